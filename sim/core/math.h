#pragma once
// Vector types (Eigen), degrees, indices, the 2D cross product, a bounding box, a smooth step, and a quantile. Double
// precision is used for patterns, base meshes and bodies; single precision for the state of the adaptive mesh and of
// the cloth.
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

namespace selvedge::sim {

using Vec2d = Eigen::Vector2d;
using Vec3d = Eigen::Vector3d;
using Vec2f = Eigen::Vector2f;
using Vec3f = Eigen::Vector3f;
using Vec4f = Eigen::Vector4f;  // a point or direction with w = 0, so that it fills one SIMD register

inline constexpr double kDegree = std::numbers::pi / 180;  // rad

// An index of a pattern or an outline, which counts in int, as containers take it. Pre: index >= 0.
constexpr std::size_t as_size(int index) {
    return static_cast<std::size_t>(index);
}

// The z component of the cross product of two 2D vectors: positive if b points to the left of a.
inline double cross2(const Vec2d& a, const Vec2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

inline Vec4f with_zero_w(const Vec3f& v) {
    return {v.x(), v.y(), v.z(), 0.0F};
}

// The smallest axis-aligned box that holds the points; empty if there are none.
inline Eigen::AlignedBox3f box_around(std::span<const Vec3f> points) {
    Eigen::AlignedBox3f box;
    for (const Vec3f& point : points) box.extend(point);
    return box;
}

// 0 below `from`, 1 above `to`, the cubic 3 t^2 - 2 t^3 between.
inline double smoothstep(double x, double from, double to) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// The q-quantile (0 <= q <= 1) of the values: always one of them, without interpolation. 0 if there are none.
inline double quantile(std::vector<double> values, double q) {
    if (values.empty()) return 0;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

}  // namespace selvedge::sim

// All modules use these types, so their names are also in the outer namespace.
namespace selvedge {

using sim::as_size;
using sim::Vec2d;
using sim::Vec2f;
using sim::Vec3d;
using sim::Vec3f;
using sim::Vec4f;

}  // namespace selvedge
