#pragma once
// Divides each outline edge into straight segments. Corners are kept. Samples are
// equally spaced in arc length and both sides of a seam get the same number n of segments, so that sample i of one side
// matches sample i (or n - i) of the other.
#include <vector>

#include "sim/mesh/garment_mesh.h"
#include "sim/mesh/triangulate.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// The number of segments for an edge, at least 1: segments of about options.target_edge, or shorter if needed to keep
// within options.chord_error of the curve. At most 10,000; throws InputError if the edge is too long for that.
int segments_needed(const Panel& panel, const OutlineEdge& edge, const MeshOptions& options);

// Segments per panel and edge, from segments_needed(). Both sides of a seam, and both sides of a slit, get the same
// number. An edge that sewing closes to a ring gets at least 3. Two edges that are not sewn together but whose ends are
// merged get at least 2, because with one segment they would coincide.
// Throws InputError for a seam to a missing panel or edge, and for an edge sewn to itself.
std::vector<std::vector<int>> count_segments(const Pattern& pattern, const MeshOptions& options);

struct SampledOutline {
    std::vector<Vec2d> points;     // m, counter-clockwise, each sample once
    std::vector<OutlineRun> runs;  // one per edge
};

// Pre: one count of at least 1 per edge.
SampledOutline sample_outline(const Panel& panel, const std::vector<int>& segments);

}  // namespace selvedge::sim
