#include "bench/thesis/limb_collider.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace selvedge::bench {

sim::Contact LimbCollider::contact(const Vec3f& p) const {
    std::vector<std::uint32_t> triangles;
    return contact(p, triangles);
}

void LimbCollider::contacts(std::span<sim::ContactBlock> blocks, float /*reach*/) const {
    std::vector<std::uint32_t> triangles;
    for (sim::ContactBlock& block : blocks)
        for (std::size_t i = 0; i < sim::kContactLanes; ++i) block.set(i, contact(block.point(i), triangles));
}

sim::Contact LimbCollider::contact(const Vec3f& p, std::vector<std::uint32_t>& triangles) const {
    const sim::Contact none{.distance = band(), .normal = Vec3f::Zero()};
    const std::optional<LimbContact> found = limbs_.contact(p, triangles);
    if (!found || std::abs(found->distance) >= band()) return none;
    constexpr float kNoDirection = 1e-5F;  // m, a shorter vector has no usable direction
    const Vec3f normal = limbs_.plane(found->triangle).head<3>();
    if (std::abs(found->distance) < kNoDirection) return {.distance = found->distance, .normal = normal};
    return {.distance = found->distance, .normal = (p - found->point) / found->distance};
}

// Each triangle that the segment crosses is listed for a point of it that is at most kReach from the crossing.
std::optional<sim::SurfaceHit> LimbCollider::first_hit(const Vec3f& from, const Vec3f& to) const {
    const Vec3f along = to - from;
    const int steps = 1 + static_cast<int>(along.norm() / (2 * band()));
    std::vector<std::uint32_t> triangles;
    for (int i = 0; i < steps; ++i) {
        const Vec3f p = from + along * ((static_cast<float>(i) + 0.5F) / static_cast<float>(steps));
        limbs_.collect_from_cylinders(p, triangles);
        limbs_.collect_from_spheres(p, triangles);
    }
    std::optional<sim::SurfaceHit> first;
    for (const std::uint32_t t : triangles) {
        const std::optional<float> fraction = limbs_.crossing(t, {from, to});
        if (!fraction || (first && first->fraction <= *fraction)) continue;
        first = sim::SurfaceHit{.point = from + *fraction * along,
                                .normal = limbs_.plane(t).head<3>(),
                                .fraction = *fraction,
                                .triangle = t};
    }
    return first;
}

}  // namespace selvedge::bench
