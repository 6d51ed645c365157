#pragma once
// Points that are asked about at once, and what is known of them.  (SPEC 3.3)
#include <array>
#include <cstddef>

#include "sim/core/vec.h"

namespace selvedge {

struct Contact {
    float distance = 0;            // m, negative inside; a Collider's band() when it is at least that far outside
    Vec3f normal = Vec3f::Zero();  // unit, the way out; zero when distance is band()
};

inline constexpr std::size_t kContactLanes = 16;

// Spare lanes hold any point, a copy of another say.
struct alignas(64) ContactBlock {
    using Lanes = std::array<float, kContactLanes>;
    Lanes x{}, y{}, z{};     // asked, m
    Lanes distance{};        // answer, m, as in Contact
    Lanes nx{}, ny{}, nz{};  // its normal

    Vec3f point(std::size_t lane) const { return {x[lane], y[lane], z[lane]}; }
    void set_point(std::size_t lane, const Vec3f& p) {
        x[lane] = p.x();
        y[lane] = p.y();
        z[lane] = p.z();
    }
    void set(std::size_t lane, const Contact& contact) {
        distance[lane] = contact.distance;
        nx[lane] = contact.normal.x();
        ny[lane] = contact.normal.y();
        nz[lane] = contact.normal.z();
    }
};

}  // namespace selvedge
