#pragma once
// The geometry of panel outlines: points and lengths of their edges (lines, quadratic and cubic Beziers, circular
// arcs), area, self-intersection, and the limits for valid outlines and seams. Edges are parametrised by arc length, so
// that equal steps give curve segments of equal length on both sides of a seam.
#include <array>
#include <span>
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// The point at the fraction t in [0, 1] of the edge's length, in the panel frame, m.
// t = 0 and t = 1 return the end vertices exactly.
Vec2d outline_point(const Panel& panel, const OutlineEdge& edge, double t);

// The same with the arc lengths of the edge measured once, for many points of it: same bits, less work.
struct EdgeLengths {
    std::array<double, 17> reached{};  // m, at the parameters 0, 1/16, ..., 1 of a Bezier; of other edges zero
};
EdgeLengths measure_lengths(const Panel& panel, const OutlineEdge& edge);
Vec2d outline_point(const Panel& panel, const OutlineEdge& edge, const EdgeLengths& lengths, double t);

// The length of the edge, m, with a relative error of about 1e-9.
double outline_length(const Panel& panel, const OutlineEdge& edge);

// The point at the curve parameter s in [0, 1] (the Bezier parameter; the length fraction for lines and arcs).
Vec2d curve_point(const Panel& panel, const OutlineEdge& edge, double s);

// Converts the fraction t of the edge's length to the curve parameter s, and back. Equal for lines and arcs.
double curve_parameter(const Panel& panel, const OutlineEdge& edge, double t);
double curve_fraction(const Panel& panel, const OutlineEdge& edge, double s);

// The circle and angles of an edge of kind Arc.
struct ArcCircle {
    Vec2d centre = Vec2d::Zero();
    double radius = 0;
    double from = 0;   // rad, angle of the start point
    double sweep = 0;  // rad, signed: positive turns left
};
ArcCircle arc_circle(const Panel& panel, const OutlineEdge& edge);

// A polyline along the edge, with both ends, at most chord_error (m) from it. A line gives two points.
std::vector<Vec2d> outline_polyline(const Panel& panel, const OutlineEdge& edge, double chord_error);

// The signed area inside the outline, m^2, positive for a counter-clockwise panel. Curves are approximated by polylines
// with a chord error of 0.1 mm.
double outline_area(const Panel& panel);

// Limits for outlines and seams. Loading rejects a file that violates them, and editing must not violate them.
inline constexpr double kShortestEdge = 1e-5;   // m
inline constexpr std::size_t kMaxEdges = 5000;  // of one panel
inline constexpr double kSmallestArea = 1e-8;   // m^2
inline constexpr double kMaxGatherRatio = 4;    // largest ratio of the lengths of a seam's sides; more is an error

// Two edges of a panel, first <= second, that cross or touch at a point other than a common end of neighbouring edges.
struct OutlineCrossing {
    std::size_t first = 0;
    std::size_t second = 0;
    Vec2d place = Vec2d::Zero();  // m, panel frame
};

struct CrossingSearch {
    std::size_t most = 20;  // maximum number of pairs of edges to report
    double clearance = 0;   // m, edges that are this close count as touching
};

// Finds one crossing for each pair of edges that cross or touch; an edge can also cross itself. Curves are approximated
// with a chord error of 0.1 mm. Pre: no edge has zero length.
std::vector<OutlineCrossing> find_outline_crossings(const Panel& panel, const CrossingSearch& search = {});

// Whether a point lies inside a closed polyline, by the parity of its crossings.
bool is_inside(const Vec2d& point, std::span<const Vec2d> outline);

}  // namespace selvedge::sim
