#pragma once
// How far a cloth is strained, from the deformation gradients of its leaf triangles.
#include <vector>

#include "sim/cloth/cloth.h"

namespace selvedge {

struct TriangleStrain {
    float warp = 0;  // length of the deformed warp direction less 1
    float weft = 0;
    float shear = 0;  // rad, angle between the deformed warp and weft directions less a right angle, unsigned
};

// One per leaf triangle, in their order.
std::vector<TriangleStrain> measure_strain(const Cloth& cloth);

}  // namespace selvedge
