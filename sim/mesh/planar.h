#pragma once
// 2D geometry functions for sampling outlines, triangulation and mesh checks.
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

// Outline samples closer than this are treated as one point (on the two sides of a slit), m.
constexpr double kWeldDistance = 1e-6;

double distance_to_segment(const Vec2d& point, const Vec2d& start, const Vec2d& end);
double distance_to_outline(const Vec2d& point, std::span<const Vec2d> outline);
// The smallest angle of a triangle (opposite the shortest side), rad; zero if two corners coincide.
double smallest_angle(const Vec2d& a, const Vec2d& b, const Vec2d& c);

// Gives a sample within kWeldDistance of an earlier one the coordinates of that one.
void weld(std::vector<Vec2d>& points);

// Finds two segments of the closed polyline (segment i runs from point i to point i + 1) that cross, that are equal
// with the same direction, or one of which ends inside the other. A segment of zero length is returned as (i, i).
// Common end points, and a segment equal to another in the opposite direction, are allowed: they form a slit. Uses
// exact predicates.
std::optional<std::pair<int, int>> find_crossing(std::span<const Vec2d> outline);

}  // namespace selvedge::sim
