#pragma once
// How many straight segments each outline edge gets, and where they meet. Corners are kept; samples lie uniformly in
// arc length, so that sample i of one side of a seam belongs to sample i (or n - i) of the other.  (SPEC 3.1)
#include <vector>

#include "sim/mesh/triangulate.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// How finely panels are cut into triangles.

struct MeshOptions {
    double target_edge = 0.05;   // m, the edge length aimed at; a T-shirt then has some 700 triangles
    double chord_error = 0.003;  // m, how far an outline curve may stand off its chords
    int relaxations = 12;        // rounds of moving interior points
    int max_triangles = 200000;  // of one panel; more is taken for an error in units

    bool operator==(const MeshOptions&) const = default;
};

// The fewest segments, at least 1, that are about options.target_edge long and stand off the curve by no more than
// options.chord_error.
int segments_needed(const Panel& panel, const OutlineEdge& edge, const MeshOptions& options);

// Segments per panel and edge: as many as needed, the same number on both sides of a seam and on the two banks of a
// slit, at least 3 round an edge that sewing closes into a ring, and at least 2 where sewing would lay two straight
// edges that are not sewn together on each other.
// Throws InputError for a seam to a missing panel or edge, and for an edge sewn to itself.
std::vector<std::vector<int>> count_segments(const Pattern& pattern, const MeshOptions& options);

struct SampledOutline {
    std::vector<Vec2d> points;     // m, counter-clockwise, each sample once
    std::vector<OutlineRun> runs;  // one per edge
};

// Pre: one count of at least 1 per edge.
SampledOutline sample_outline(const Panel& panel, const std::vector<int>& segments);

}  // namespace selvedge::sim
