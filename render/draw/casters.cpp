#include "render/draw/casters.h"

#include <algorithm>
#include <cmath>

#include "sim/core/assert.h"

namespace selvedge::render {
namespace {

// -1..1 to texels, whose centres are integers, and depth 0..1.
Eigen::Matrix4f texel_matrix(int side_px) {
    const float half = static_cast<float>(side_px) / 2;
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
    matrix.diagonal() << half, half, 0.5F, 1;
    matrix.block<3, 1>(0, 3) << half - 0.5F, half - 0.5F, 0.5F;
    return matrix;
}

// Edge function of the line between two points: at() >= 0 inside a triangle whose orientation is `sign`.
struct Edge {
    float dx = 0, dy = 0, constant = 0;

    Edge(const Vec3f& from, const Vec3f& to, float sign)
        : dx(sign * (from.y() - to.y())), dy(sign * (to.x() - from.x())), constant(-(dx * from.x() + dy * from.y())) {}
    float at(float x, float y) const { return dx * x + dy * y + constant; }
};

void widen(DepthRange::Span& span, float depth) {
    span.nearest = std::min(span.nearest, depth);
    span.farthest = std::max(span.farthest, depth);
}

void draw_triangle(DepthRange& picture, const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    const float last = static_cast<float>(picture.side_px - 1);
    const int left = static_cast<int>(std::ceil(std::max(std::min({a.x(), b.x(), c.x()}), 0.0F)));
    const int right = static_cast<int>(std::floor(std::min(std::max({a.x(), b.x(), c.x()}), last)));
    const int low = static_cast<int>(std::ceil(std::max(std::min({a.y(), b.y(), c.y()}), 0.0F)));
    const int high = static_cast<int>(std::floor(std::min(std::max({a.y(), b.y(), c.y()}), last)));
    if (left > right || low > high) return;
    const float area = (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y());
    if (std::abs(area) < 1e-9F) return;
    const float sign = area > 0 ? 1.0F : -1.0F;
    const Edge to_a(b, c, sign), to_b(c, a, sign), to_c(a, b, sign);
    const float inverse = sign / area;
    for (int y = low; y <= high; ++y) {
        DepthRange::Span* row = &picture.spans[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.side_px)];
        for (int x = left; x <= right; ++x) {
            const float s = to_a.at(float(x), float(y)), t = to_b.at(float(x), float(y)),
                        r = to_c.at(float(x), float(y));
            if (s < 0 || t < 0 || r < 0) continue;
            widen(row[x], (s * a.z() + t * b.z() + r * c.z()) * inverse);
        }
    }
}

}  // namespace

DepthRange empty_depth_range(const Bounds& bounds, const Vec3f& direction, int side_px) {
    DepthRange picture;
    picture.matrix = texel_matrix(side_px) * parallel_matrix(bounds, direction);
    picture.side_px = side_px;
    picture.spans.resize(static_cast<std::size_t>(side_px) * static_cast<std::size_t>(side_px));
    return picture;
}

void draw_casters(DepthRange& picture, const Casters& casters) {
    const Eigen::Matrix3f turn = picture.matrix.block<3, 3>(0, 0);
    const Vec3f shift = picture.matrix.block<3, 1>(0, 3);
    std::vector<Vec3f> seen;
    seen.reserve(casters.x.size());
    for (const Vec3f& point : casters.x) seen.emplace_back(turn * point + shift);
    for (const auto& [a, b, c] : casters.triangles) draw_triangle(picture, seen[a], seen[b], seen[c]);
}

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
    Bounds bounds{.centre = sim::box_around(points).center(), .radius = 0};
    for (const Vec3f& point : points) bounds.radius = std::max(bounds.radius, (point - bounds.centre).norm());
    bounds.radius = std::max(bounds.radius * 1.02F, 0.01F);
    return bounds;
}

Bounds steady_bounds_of(const std::vector<Vec3f>& points) {
    const Bounds tight = bounds_of(points);
    const float step = std::exp2(std::floor(std::log2(tight.radius)) - 4);  // m: a sixteenth of the radius, or less
    return {.centre = step * (tight.centre / step).array().round().matrix(),
            .radius = step * std::ceil(tight.radius / step + 1)};  // rounding moves the centre by less than a step
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

}  // namespace selvedge::render
