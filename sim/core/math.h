#pragma once
// Vectors. Double in pattern, mesh and body building; float in the adaptive mesh's and the cloth's state.
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <vector>

namespace selvedge::sim {

using Vec2d = Eigen::Vector2d;
using Vec3d = Eigen::Vector3d;
using Vec2f = Eigen::Vector2f;
using Vec3f = Eigen::Vector3f;
using Vec4f = Eigen::Vector4f;  // a point or direction with a fourth 0, so that it fills one vector register

// z of the cross product of two plane vectors: positive when b lies to the left of a.
inline double cross2(const Vec2d& a, const Vec2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

inline Vec4f padded(const Vec3f& v) {
    return {v.x(), v.y(), v.z(), 0.0F};
}

// Order statistics of a handful of figures.

// The value below which the share q (0..1) of the others lies: one of them, none in between. 0 when there are none.
inline double quantile(std::vector<double> values, double q) {
    if (values.empty()) return 0;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

}  // namespace selvedge::sim

// Every module writes vectors; their names stand in the outer namespace.
namespace selvedge {

using sim::Vec2d;
using sim::Vec2f;
using sim::Vec3d;
using sim::Vec3f;
using sim::Vec4f;

}  // namespace selvedge
