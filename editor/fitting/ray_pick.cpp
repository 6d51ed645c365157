#include "editor/fitting/ray_pick.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace selvedge {

// Moeller and Trumbore 1997, both sides.
std::optional<MeshHit> nearest_hit(const Ray& ray, const std::vector<Vec3f>& x, const TriangleList& triangles) {
    std::optional<MeshHit> nearest;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const Vec3f& a = x[triangles[t][0]];
        const Vec3f ab = x[triangles[t][1]] - a, ac = x[triangles[t][2]] - a;
        const Vec3f across = ray.direction.cross(ac);
        const float volume = ab.dot(across);
        if (volume == 0) continue;
        const Vec3f from_a = ray.origin - a;
        const float v = from_a.dot(across) / volume;
        if (!(v >= 0 && v <= 1)) continue;
        const Vec3f normal = from_a.cross(ab);
        const float w = ray.direction.dot(normal) / volume;
        if (!(w >= 0 && v + w <= 1)) continue;
        const float distance = ac.dot(normal) / volume;
        if (!(distance > 0 && distance < least)) continue;
        least = distance;
        nearest = {.distance = distance, .triangle = static_cast<std::uint32_t>(t), .weights = {1 - v - w, v, w}};
    }
    return nearest;
}

std::optional<ScreenDistance> distance_to_point(const Viewing& viewing, const Vec2f& px, const Vec3f& x) {
    const std::optional<Vec2f> at = px_of(viewing, x);
    if (!at) return std::nullopt;
    return ScreenDistance{.px = (*at - px).norm(), .depth = depth_of(viewing, x)};
}

std::optional<ScreenDistance> distance_to_path(const Viewing& viewing, const Vec2f& px,
                                               const std::vector<Vec3f>& path) {
    ScreenDistance nearest{.px = std::numeric_limits<float>::infinity()};
    for (std::size_t i = 1; i < path.size(); ++i) {
        const std::optional<Vec2f> from = px_of(viewing, path[i - 1]), to = px_of(viewing, path[i]);
        if (!from || !to) continue;
        const Vec2f along = *to - *from;
        const float length2 = along.squaredNorm();
        const float t = length2 > 0 ? std::clamp((px - *from).dot(along) / length2, 0.0F, 1.0F) : 0.0F;
        const float distance = (*from + t * along - px).norm();
        if (distance < nearest.px)
            nearest = {.px = distance, .depth = depth_of(viewing, path[i - 1] + t * (path[i] - path[i - 1]))};
    }
    if (!std::isfinite(nearest.px)) return std::nullopt;
    return nearest;
}

}  // namespace selvedge
