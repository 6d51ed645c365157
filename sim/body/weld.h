#pragma once
// Which points are the same point.
#include <vector>

#include "sim/core/vec.h"

namespace selvedge {

// For each point the first one no farther than `distance` (m) from it that stands for itself. Pre: distance > 0.
std::vector<int> weld(const std::vector<Vec3d>& x, double distance);

}  // namespace selvedge
