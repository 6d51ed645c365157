#include "sim/collide/moving_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "sim/core/assert.h"
#include "sim/core/morton.h"

namespace selvedge::sim {
namespace {

Vec3f unit_normal(const std::array<Vec3f, 3>& x) {
    return (x[1] - x[0]).cross(x[2] - x[0]).stableNormalized();
}

}  // namespace

PlaneNow plane_now(const MovingPlane& plane, const Vec3f& x, float share) {
    const Vec3f normal = (plane.normal + share * plane.turn).normalized();
    return {normal, normal.dot(x - plane.point - share * plane.motion)};
}

MovingBodyCollider::MovingBodyCollider(const Body& body) : bvh_(body), thin_parts_(bvh_) {
    place(bvh_.points());
}

void MovingBodyCollider::move_to(std::span<const Vec3f> x, const Region& region) {
    SELVEDGE_ASSERT(x.size() == bvh_.points().size());
    bvh_.sweep_to(x, region);
    float motion = 0;
    for (std::size_t v = 0; v < x.size(); ++v) motion = std::max(motion, (x[v] - bvh_.points()[v]).squaredNorm());
    longest_motion_ = std::sqrt(motion);
    longest_deformation_ = deformation_to(x, region);
}

float MovingBodyCollider::deformation_to(std::span<const Vec3f> x, const Region& region) const {
    const std::span<const Vec3f> from = bvh_.points();
    const Vec3f drift = bvh_.drift_to(x);
    float longest = 0;
    for (std::size_t v = 0; v < x.size(); ++v) {
        const float squared = (x[v] - from[v] - drift).squaredNorm();
        if (squared > longest && (region.contains(from[v]) || region.contains(x[v] - drift))) longest = squared;
    }
    return std::sqrt(longest);
}

void MovingBodyCollider::arrive() {
    bvh_.arrive();
    longest_motion_ = longest_deformation_ = 0;
}

void MovingBodyCollider::place(std::span<const Vec3f> x) {
    move_to(x);
    arrive();
}

MovingPlane MovingBodyCollider::plane_at(std::uint32_t triangle, const Vec3f& p) const {
    const ClosestPoint closest = bvh_.closest_on(triangle, p);
    MovingPlane plane{.point = closest.point, .normal = closest.normal};
    if (longest_motion_ == 0) return plane;
    const auto [a, b, c] = bvh_.triangles()[triangle];
    const std::array<Vec3f, 3> start{bvh_.points()[a], bvh_.points()[b], bvh_.points()[c]};
    const std::span<const Vec3f> ends = bvh_.end_points();
    const std::array<Vec3f, 3> end{ends[a], ends[b], ends[c]};
    const std::array<float, 3> shares = barycentric(closest.point, start[0], start[1], start[2]);
    plane.motion = shares[0] * end[0] + shares[1] * end[1] + shares[2] * end[2] - closest.point;
    plane.turn = unit_normal(end) - unit_normal(start);
    return plane;
}

Contact MovingBodyCollider::contact(const Vec3f& p) const {
    const auto closest = bvh_.closest(p, kDeepest);
    if (!closest || closest->distance >= band()) return {band(), Vec3f::Zero()};
    return {closest->distance, closest->normal};
}

// Sixteen points at a time, in the order of their Morton codes, so that each sixteen are near each other.
void MovingBodyCollider::contacts(std::span<ContactBlock> blocks, float reach) const {
    const std::size_t count = blocks.size() * kContactLanes;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order(count);
    for (std::size_t i = 0; i < count; ++i)
        order[i] = {morton_code(blocks[i / kContactLanes].point(i % kContactLanes)), std::uint32_t(i)};
    std::ranges::sort(order);
    for (std::size_t first = 0; first < count; first += kContactLanes) {
        PointGroup group;
        const auto at = [&](std::size_t lane) { return std::size_t(order[first + lane].second); };
        for (std::size_t lane = 0; lane < kContactLanes; ++lane)
            group.start(lane, blocks[at(lane) / kContactLanes].point(at(lane) % kContactLanes),
                        std::max(reach, kDeepest));
        bvh_.find_nearest(group);
        for (std::size_t lane = 0; lane < kContactLanes; ++lane) {
            Contact contact{.distance = band()};
            if (group.triangle[lane] != NearestTriangle::kNone) {
                const ClosestPoint closest = bvh_.closest_on(group.triangle[lane], group.point(lane));
                if (closest.distance < band()) contact = {closest.distance, closest.normal};
            }
            blocks[at(lane) / kContactLanes].set(at(lane) % kContactLanes, contact);
        }
    }
}

}  // namespace selvedge::sim
