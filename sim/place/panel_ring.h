#pragma once
// Panels that lie side by side round the trunk, as the gores of a corset: they start on one cylinder.
#include <functional>
#include <vector>

#include "sim/pattern/pattern.h"
#include "sim/place/panel_flanks.h"

namespace selvedge::sim {

// A panel of a ring, from the front on to the left of the body.
struct RingPlace {
    std::size_t panel = 0;
    double turn = 0;  // rad, of its middle about the vertical, from the front
    double rise = 0;  // m, of its origin over the narrowest level of the ring
};

// The ring to which a panel belongs: what is sewn to its sides, and on to their sides, of panels that may be of it. A
// panel that is the mirror image of none lies at the front, else the middle one. Empty: it has no neighbours.
std::vector<RingPlace> ring_of(const Pattern& pattern, const SewnEdges& sewn, std::size_t first,
                               const std::function<bool(std::size_t)>& may_be);

// Bends its panels to one cylinder about the vertical through the waist's middle, as wide as they are together, but not
// narrower than that, m.
void arrange_ring(Pattern& pattern, const std::vector<RingPlace>& ring, const Vec3d& waist, double least_radius);

}  // namespace selvedge::sim
