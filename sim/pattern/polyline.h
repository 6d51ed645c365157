#pragma once
// Measures of open polylines.
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

double polyline_length(const std::vector<Vec2d>& line);  // 0 for fewer than two points

// Infinite for a polyline of fewer than two points.
double distance_to_polyline(const Vec2d& point, const std::vector<Vec2d>& line);

// Empty without points.
Eigen::AlignedBox2d box_around(const std::vector<Vec2d>& points);

}  // namespace selvedge::sim
