#pragma once
// The curves of an outline: points, tangents and lengths. Lines, quadratic and cubic Beziers and circular arcs are all
// walked by arc length, so that equal steps give segments of equal length, on both sides of a seam.  (SPEC 3.1)
#include <span>
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// The point at the fraction t in [0, 1] of the edge's length, in panel coordinates, m.
// t = 0 and t = 1 give the end vertices exactly.
Vec2d outline_point(const Panel& panel, const OutlineEdge& edge, double t);

// The length of the edge, m, to about 1e-9 of itself.
double outline_length(const Panel& panel, const OutlineEdge& edge);

// The point at the curve's own parameter s in [0, 1]: as outline_point, but not spaced by length.
Vec2d curve_point(const Panel& panel, const OutlineEdge& edge, double s);

// The curve's own parameter at the fraction t of the edge's length, and the other way round. Lines and arcs: the same.
double curve_parameter(const Panel& panel, const OutlineEdge& edge, double t);
double curve_fraction(const Panel& panel, const OutlineEdge& edge, double s);

// The circle that an edge of kind Arc runs along.
struct ArcCircle {
    Vec2d centre = Vec2d::Zero();
    double radius = 0;
    double from = 0;   // rad, angle of the start point
    double sweep = 0;  // rad, signed: positive turns left
};
ArcCircle arc_circle(const Panel& panel, const OutlineEdge& edge);

// A polyline along the edge, both ends included, that keeps within chord_error (m) of it; a line gives two points.
std::vector<Vec2d> outline_polyline(const Panel& panel, const OutlineEdge& edge, double chord_error);

// The signed area inside the outline, m^2, curves sampled to 0.1 mm: positive for a counter-clockwise panel.
double outline_area(const Panel& panel);

// Whether an outline keeps clear of itself, and the limits that outlines and seams keep to: what loading refuses and
// what drafting must not make.

inline constexpr double kShortestEdge = 1e-5;    // m
inline constexpr std::size_t kMostEdges = 5000;  // of one panel
inline constexpr double kSmallestArea = 1e-8;    // m^2
inline constexpr double kMostGathers = 4;        // a seam side this many times its partner is a slip of the pen

// Two edges of a panel, first <= second, that cross or touch elsewhere than where neighbours join.
struct OutlineCrossing {
    std::size_t first = 0;
    std::size_t second = 0;
    Vec2d place = Vec2d::Zero();  // m, held frame
};

struct CrossingSearch {
    std::size_t most = 20;  // pairs of edges to report: a scribble need not be listed whole
    double clearance = 0;   // m, what comes this near to something else touches it
};

// Curves are followed to 0.1 mm. The first crossing of each pair of edges. Pre: edges have length.
std::vector<OutlineCrossing> find_outline_crossings(const Panel& panel, const CrossingSearch& search = {});

// Whether a point lies inside a closed polyline, by the parity of its crossings.
bool is_inside(const Vec2d& point, std::span<const Vec2d> outline);

}  // namespace selvedge::sim
