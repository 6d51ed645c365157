#include "sim/collide/moving_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "sim/core/assert.h"
#include "sim/core/morton.h"

namespace selvedge::sim {
namespace {

Vec3f unit_normal(const std::array<Vec3f, 3>& x) {
    return (x[1] - x[0]).cross(x[2] - x[0]).stableNormalized();
}

}  // namespace

PlaneNow plane_now(const TangentPlane& plane, const Vec3f& x, float share) {
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

TangentPlane MovingBodyCollider::plane_at(std::uint32_t triangle, const Vec3f& p) const {
    const ClosestPoint closest = bvh_.closest_on(triangle, p);
    TangentPlane plane{.point = closest.point, .normal = closest.normal};
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
std::vector<std::optional<ClosestPoint>> MovingBodyCollider::closest(std::span<const SearchPoint> points,
                                                                     float radius) const {
    std::vector<CodedPoint> order(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = {morton_code(points[i].x), std::uint32_t(i)};
    sort_by_code(order);
    std::vector<std::optional<ClosestPoint>> found(points.size());
    for (std::size_t first = 0; first < order.size(); first += PointGroup::kPoints) {
        const std::size_t count = std::min(PointGroup::kPoints, order.size() - first);
        PointGroup group;
        for (std::size_t slot = 0; slot < PointGroup::kPoints; ++slot) {
            const SearchPoint& point = points[order[first + std::min(slot, count - 1)].index];
            group.start(slot, point.x, radius);
            if (point.known != NearestTriangle::kNone) group.start_with(slot, bvh_.distance_to(point.known, point.x));
        }
        bvh_.find_nearest(group);
        for (std::size_t slot = 0; slot < count; ++slot) {
            if (group.triangle[slot] == NearestTriangle::kNone) continue;
            found[order[first + slot].index] = bvh_.closest_on(group.triangle[slot], group.point(slot));
        }
    }
    return found;
}

void MovingBodyCollider::contacts(std::span<ContactBlock> blocks, float reach) const {
    std::vector<SearchPoint> points(blocks.size() * kContactLanes);
    for (std::size_t i = 0; i < points.size(); ++i) points[i].x = blocks[i / kContactLanes].point(i % kContactLanes);
    const std::vector<std::optional<ClosestPoint>> found = closest(points, std::max(reach, kDeepest));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool is_near = found[i] && found[i]->distance < band();
        blocks[i / kContactLanes].set(
            i % kContactLanes, is_near ? Contact{found[i]->distance, found[i]->normal} : Contact{.distance = band()});
    }
}

}  // namespace selvedge::sim
