#pragma once
// How far a garment stands off the body.
#include <vector>

#include "sim/body/body.h"
#include "sim/core/vec.h"

namespace selvedge {

// m from each point to the nearest of the body's surface, negative inside. Exact but for rounding.
std::vector<float> measure_clearance(const std::vector<Vec3f>& points, const Body& body);

}  // namespace selvedge
