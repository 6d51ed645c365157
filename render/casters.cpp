#include "render/casters.h"

#include <algorithm>
#include <cmath>

#include "sim/core/assert.h"

namespace selvedge {

namespace {

void add(Casters& casters, const std::vector<Vec3f>& x, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    const auto base = static_cast<std::uint32_t>(casters.x.size());
    casters.x.insert(casters.x.end(), x.begin(), x.end());
    for (const auto& [a, b, c] : triangles) casters.triangles.push_back({a + base, b + base, c + base});
}

}  // namespace

Casters cloth_casters_of(const Scene& scene) {
    Casters casters;
    for (const ClothItem& cloth : scene.cloths) add(casters, cloth.mesh.x, cloth.mesh.triangles);
    return casters;
}

Casters body_casters_of(const Scene& scene) {
    Casters casters;
    for (const BodyItem& body : scene.bodies) add(casters, body.x, body.triangles);
    return casters;
}

Casters casters_of(const Scene& scene) {
    Casters casters = cloth_casters_of(scene);
    const Casters bodies = body_casters_of(scene);
    add(casters, bodies.x, bodies.triangles);
    return casters;
}

Bounds bounds_of(const std::vector<Vec3f>& points) {
    SELVEDGE_ASSERT(!points.empty());
    Vec3f low = points.front(), high = points.front();
    for (const Vec3f& point : points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    Bounds bounds{.centre = (low + high) / 2, .radius = 0};
    for (const Vec3f& point : points) bounds.radius = std::max(bounds.radius, (point - bounds.centre).norm());
    bounds.radius = std::max(bounds.radius * 1.02F, 0.01F);
    return bounds;
}

Bounds steady_bounds_of(const std::vector<Vec3f>& points) {
    const Bounds tight = bounds_of(points);
    const float step = std::exp2(std::floor(std::log2(tight.radius)) - 4);  // a sixteenth of the radius, or less
    return {.centre = step * (tight.centre / step).array().round().matrix(),
            .radius = step * std::ceil(tight.radius / step + 1)};  // the centre moved by less than a step
}

Eigen::Matrix4f parallel_matrix(const Bounds& bounds, const Vec3f& direction) {
    const Vec3f helper = std::abs(direction.y()) < 0.9F ? Vec3f(Vec3f::UnitY()) : Vec3f(Vec3f::UnitX());
    const Vec3f right = helper.cross(direction).normalized();
    const Vec3f up = direction.cross(right);
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
    matrix.block<1, 3>(0, 0) = right.transpose() / bounds.radius;
    matrix.block<1, 3>(1, 0) = up.transpose() / bounds.radius;
    matrix.block<1, 3>(2, 0) = -direction.transpose() / bounds.radius;
    matrix.block<3, 1>(0, 3) = -matrix.block<3, 3>(0, 0) * bounds.centre;
    return matrix;
}

}  // namespace selvedge
