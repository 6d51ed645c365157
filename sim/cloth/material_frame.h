#pragma once
// The warp and weft directions of a triangle as combinations of its edges.  (Baraff and Witkin 1998)
#include <array>
#include <cmath>

#include "sim/core/math.h"

namespace selvedge::sim {

// Unit vectors in material coordinates.
inline Vec2f warp_direction(float grain_angle) {
    return {-std::sin(grain_angle), std::cos(grain_angle)};
}

inline Vec2f weft_direction(float grain_angle) {
    return {std::cos(grain_angle), std::sin(grain_angle)};
}

// With e1 = x1 - x0, e2 = x2 - x0 the deformed warp direction is a[0] e1 + a[1] e2 and the deformed weft direction is
// b[0] e1 + b[1] e2. Both have length 1 at rest.
struct MaterialFrame {
    std::array<float, 2> a{};
    std::array<float, 2> b{};
    float area = 0;  // m^2, at rest
};

// u: the corners' material coordinates, m, anticlockwise; grain_angle: from the panel's +y to the warp, rad.
inline MaterialFrame material_frame(const std::array<Vec2f, 3>& u, float grain_angle) {
    const Vec2f e1 = u[1] - u[0];
    const Vec2f e2 = u[2] - u[0];
    const Vec2f warp = warp_direction(grain_angle);
    const Vec2f weft = weft_direction(grain_angle);
    const float s1 = warp.dot(e1);
    const float s2 = warp.dot(e2);
    const float t1 = weft.dot(e1);
    const float t2 = weft.dot(e2);
    const float det = s1 * t2 - s2 * t1;
    return {.a = {t2 / det, -t1 / det}, .b = {-s2 / det, s1 / det}, .area = 0.5F * std::abs(det)};
}

}  // namespace selvedge::sim
