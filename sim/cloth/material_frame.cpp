#include "sim/cloth/material_frame.h"

#include <cmath>

namespace selvedge {

Vec2f warp_direction(float grain_angle) {
    return {-std::sin(grain_angle), std::cos(grain_angle)};
}

Vec2f weft_direction(float grain_angle) {
    return {std::cos(grain_angle), std::sin(grain_angle)};
}

MaterialFrame material_frame(const std::array<Vec2f, 3>& u, float grain_angle) {
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

}  // namespace selvedge
