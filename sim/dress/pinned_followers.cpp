#include "sim/dress/pinned_followers.h"

#include <limits>

namespace selvedge::sim {

PinnedFollowers::Follower PinnedFollowers::bound(const Vec3f& x, const SurfaceBvh& surface) {
    const auto closest = surface.closest(x, std::numeric_limits<float>::infinity());
    if (!closest) return {};
    const auto [a, b, c] = surface.triangles()[closest->triangle];
    const std::span<const Vec3f> points = surface.points();
    return {.is_bound = true,
            .triangle = closest->triangle,
            .shares = barycentric(x, points[a], points[b], points[c]),
            .height = surface.face_normal(closest->triangle).dot(x - points[a])};
}

Vec3f PinnedFollowers::place_of(const Follower& follower, const SurfaceBvh& surface, std::span<const Vec3f> x) {
    const auto [a, b, c] = surface.triangles()[follower.triangle];
    const Vec3f normal = (x[b] - x[a]).cross(x[c] - x[a]).stableNormalized();
    return follower.shares[0] * x[a] + follower.shares[1] * x[b] + follower.shares[2] * x[c] + follower.height * normal;
}

// An adaptation may have given an id to another vertex, which is then elsewhere.
std::span<const KinematicVertex> PinnedFollowers::follow(const Cloth& cloth, const SurfaceBvh& surface,
                                                         std::span<const Vec3f> end) {
    constexpr float kElsewhere = 0.001F;  // m, from where the follower of that id would be
    places_.clear();
    followers_.resize(cloth.x.size());
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        if (!cloth.is_pinned[v.value]) continue;
        const Vec3f x = cloth.x[v.value].head<3>();
        Follower& follower = followers_[v.value];
        if (!follower.is_bound || (place_of(follower, surface, surface.points()) - x).norm() > kElsewhere) {
            follower = bound(x, surface);
        }
        places_.push_back({v.value, follower.is_bound ? place_of(follower, surface, end) : x});
    }
    return places_;
}

}  // namespace selvedge::sim
