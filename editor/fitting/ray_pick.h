#pragma once
// What is under the cursor: triangles that a ray meets, and points and lines that are near it on the screen.
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "editor/fitting/view_ray.h"

namespace selvedge {

using TriangleList = std::vector<std::array<std::uint32_t, 3>>;

struct MeshHit {
    float distance = 0;  // m, along the ray
    std::uint32_t triangle = 0;
    Vec3f weights = Vec3f::Zero();  // of its corners
};

// The nearest hit, on either side of a triangle. Looks at every triangle: 25,000 take some 0.2 ms.
std::optional<MeshHit> nearest_hit(const Ray& ray, const std::vector<Vec3f>& x, const TriangleList& triangles);

// How near the cursor a thing is on the screen, and how far from the eye there.
struct ScreenDistance {
    float px = 0;
    float depth = 0;  // m
};

// None: it is behind the eye.
std::optional<ScreenDistance> distance_to_point(const Viewing& viewing, const Vec2f& px, const Vec3f& x);

// To the nearest of the path's straight parts; those with an end behind the eye are passed over.
std::optional<ScreenDistance> distance_to_path(const Viewing& viewing, const Vec2f& px, const std::vector<Vec3f>& path);

}  // namespace selvedge
