#pragma once
// Small geometry of the plane that sampling, triangulating and checking share.
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

// Outline samples nearer than this are one point of the plane (the two banks of a slit), m.
constexpr double kWeldDistance = 1e-6;

double distance_to_segment(const Vec2d& point, const Vec2d& start, const Vec2d& end);
double distance_to_outline(const Vec2d& point, std::span<const Vec2d> outline);
// The angle opposite the shortest side, rad; zero where two corners coincide.
double smallest_angle(const Vec2d& a, const Vec2d& b, const Vec2d& c);

// Gives samples within kWeldDistance of each other the same coordinates: those of the first.
void weld(std::vector<Vec2d>& points);

// Two segments of the closed polyline (segment i runs from point i to i + 1) that cross, overlap in the same
// direction, or of which one ends on the other; or twice the same segment where it has no length. Running back along
// a segment and meeting in common end points is allowed: that is a slit. Exact.
std::optional<std::pair<int, int>> find_crossing(std::span<const Vec2d> outline);

}  // namespace selvedge::sim
