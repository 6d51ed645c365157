#pragma once
// Divides each outline edge into straight segments, and sets the options of meshing. Corners are kept. Samples are
// equally spaced in arc length and both sides of a seam get the same number n of segments, so that sample i of one side
// matches sample i (or n - i) of the other.
#include <vector>

#include "sim/mesh/triangulate.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// The resolution and limits of meshing.
struct MeshOptions {
    double target_edge = 0.05;   // m, target edge length; 0.05 gives about 700 triangles for a T-shirt
    double chord_error = 0.003;  // m, largest distance of an outline curve from its chords
    int relaxations = 12;        // iterations of moving interior points
    int max_triangles = 200000;  // per panel; if more are needed, the units are probably wrong

    bool operator==(const MeshOptions&) const = default;
};

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
