#pragma once
// Outlines in the plane. Divides each outline edge into straight segments. Corners are kept. Samples are
// equally spaced in arc length and both sides of a seam get the same number n of segments, so that sample i of one side
// matches sample i (or n - i) of the other.
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "sim/core/math.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/mesh/triangulate.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// The number of segments for an edge, at least 1: segments of about options.target_edge, or shorter if needed to keep
// within options.chord_error of the curve. At most 10,000; throws InputError if the edge is too long for that.
int segments_needed(const Panel& panel, const OutlineEdge& edge, const MeshOptions& options);

// Segments per panel and edge, from segments_needed(). Both sides of a seam, and both sides of a slit, get the same
// number. An edge that sewing closes to a ring gets at least 3. Two edges that are not sewn together but whose ends are
// merged get at least 2, because with one segment they would coincide. An edge shorter than 2 mm, a stitch, gets none,
// if what it is sewn to is as short: it becomes a point.
// Throws InputError for a seam to a missing panel or edge, and for an edge sewn to itself.
std::vector<std::vector<int>> count_segments(const Pattern& pattern, const MeshOptions& options);

struct SampledOutline {
    std::vector<Vec2d> points;     // m, counter-clockwise, each sample once
    std::vector<OutlineRun> runs;  // one per edge
};

// Pre: one count per edge.
SampledOutline sample_outline(const Panel& panel, const std::vector<int>& segments);

// 2D geometry functions for sampling outlines, triangulation and mesh checks.

// Outline samples closer than this are treated as one point (on the two sides of a slit), m.
constexpr double kWeldDistance = 1e-6;

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
