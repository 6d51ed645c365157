#pragma once
// The surface of a cloth for its contact with itself: the leaf triangles, ordered so that successive ones are near each
// other, with the thickness and friction of their fabrics.
#include <cstdint>
#include <vector>

#include "sim/selfcontact/self_contact.h"

namespace selvedge::sim {

struct Cloth;

// Contact of the cloth with itself. The surface is made anew when the mesh has changed.
struct SelfContactState {
    SelfContact contact{};
    std::vector<std::uint32_t> base_order{};  // base triangles, by panel and then along a Z-order curve
    // By vertex of the base mesh: vertices that are being sewn together have the same number. Empty: none are.
    std::vector<std::uint32_t> sewn{};
    bool has_surface = false;  // whether the contact has the surface of the present leaves
};

// Gives the contact the surface of the present leaves, unless it has it already.
void update_contact_surface(Cloth& cloth);

// SelfContact::clearances() of the cloth. Empty if its steps do not keep it apart (StepOptions::self_contact).
std::vector<float> self_contact_clearances(Cloth& cloth);

// The surface of the present leaves, for tests of the whole cloth; with the base triangles in that order, or in the
// usual one.
ContactSurface contact_surface(const Cloth& cloth, const std::vector<std::uint32_t>& base_order);
ContactSurface contact_surface(const Cloth& cloth);

// Base triangles by panel and then along a Z-order curve through their material coordinates, so that groups of
// successive triangles are compact patches of cloth however the cloth hangs.  (Morton 1966)
std::vector<std::uint32_t> order_of_base_triangles(const Cloth& cloth);

}  // namespace selvedge::sim
