#pragma once
// Distances of points from segments and closed polylines of the plane; segments and rays, segments and boxes.
#include <span>

#include "sim/core/math.h"

namespace selvedge::sim {

// The fraction of the segment, 0..1, that is nearest to a point; 0 if it has no length.
double nearest_fraction(const Vec2d& point, const Vec2d& start, const Vec2d& end);

double distance_to_segment(const Vec2d& point, const Vec2d& start, const Vec2d& end);

// Whether the ray from the point in the direction of +x crosses the segment. Of a closed polyline it crosses an odd
// number where the point is inside.
bool is_crossed_rightwards(const Vec2d& point, const Vec2d& start, const Vec2d& end);

// Infinite for a polyline without points.
double distance_to_outline(const Vec2d& point, std::span<const Vec2d> outline);

// Whether a point of the segment lies in the box or on its boundary.  (Liang and Barsky 1984)
bool segment_meets_box(const Vec2d& start, const Vec2d& end, const Eigen::AlignedBox2d& box);

}  // namespace selvedge::sim
