#pragma once
// How a triangle's edges make up its warp and weft.  (Baraff and Witkin 1998)
#include <array>

#include "sim/core/vec.h"

namespace selvedge {

// With e1 = x1 - x0, e2 = x2 - x0 the deformed warp direction is a[0] e1 + a[1] e2, the deformed weft direction
// b[0] e1 + b[1] e2. Both have length 1 at rest.
struct MaterialFrame {
    std::array<float, 2> a{};
    std::array<float, 2> b{};
    float area = 0;  // m^2, at rest
};

// u: the corners' material coordinates, m, counter-clockwise; grain_angle: from the panel's +y to the warp, rad.
MaterialFrame material_frame(const std::array<Vec2f, 3>& u, float grain_angle);

// Unit, in the panel's plane.
Vec2f warp_direction(float grain_angle);
Vec2f weft_direction(float grain_angle);

}  // namespace selvedge
