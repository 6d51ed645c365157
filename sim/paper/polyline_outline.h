#pragma once
// From a polyline of many points, as DXF has it, to an outline of few edges: straight runs become lines, curved ones
// cubic Bezier curves, corners stay.
#include <vector>

#include "sim/paper/drawing.h"

namespace selvedge::sim {

struct PolylineOptions {
    double tolerance = 5e-5;        // in the points' unit: of the curves from the points
    std::vector<int> corners = {};  // indices of points that the file calls corners; empty: found by their turns
};

// Without equal neighbours. Closed: the last point joins the first.
DrawnPath outline_of_points(std::vector<Vec2d> points, bool is_closed, const PolylineOptions& options);

// The corners of a polyline: points whose turn is large, and much larger than those around them.
std::vector<int> find_corners(const std::vector<Vec2d>& points, bool is_closed);

}  // namespace selvedge::sim
