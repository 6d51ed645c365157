#pragma once
// Fits cubic Bezier curves to points in order, as few as a tolerance allows.  (Schneider 1990, "An Algorithm for
// Automatically Fitting Digitized Curves", Graphics Gems)
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

using CubicPoints = std::array<Vec2d, 4>;  // start, two control points, end

struct CurveFitOptions {
    double tolerance = 5e-5;                  // in the points' unit: largest distance of a point from the curve
    std::optional<Vec2d> start_tangent = {};  // unit, away from the start; none: from the first points
    std::optional<Vec2d> end_tangent = {};    // unit, back into the curve from the end
};

// The curves in order, each beginning where the last one ends; the first point and the last one are met exactly, and
// neighbours share their tangent. Empty for fewer than two different points.
std::vector<CubicPoints> fit_curve(std::span<const Vec2d> points, const CurveFitOptions& options = {});

// A point of the curve at the parameter s, 0..1.
Vec2d point_on(const CubicPoints& cubic, double s);

}  // namespace selvedge::sim
