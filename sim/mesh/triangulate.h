#pragma once
// Triangulates one panel: constrained Delaunay triangulation of its sampled outline and of interior points placed on a
// hexagonal grid, then smoothing and local repair of the interior. No point is added on the outline, because the
// samples of a seam's two sides must match.
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "sim/core/math.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// The part of the outline that belongs to one OutlineEdge: outline[first], outline[first+1], ...,
// outline[first+segments] (indices modulo the outline's size).
struct OutlineRun {
    int first = 0;
    int segments = 0;
};

struct PanelMesh {
    std::vector<Vec2d> u;                       // material coordinates, m, panel frame
    std::vector<std::array<int, 3>> triangles;  // counter-clockwise
    std::vector<int> outline;                   // outline vertices, counter-clockwise, each once
    std::vector<OutlineRun> runs;               // one per OutlineEdge of the panel, same order
};

struct TriangulateOptions {
    double target_edge = 0.05;   // m
    int relaxations = 12;        // iterations of moving interior points
    int max_triangles = 200000;  // of this panel
};

// segments: per outline edge, see count_segments(). The outline may touch itself along a slit of zero width, or in a
// point if the cloth is not pinched there; the two sides keep separate vertices. Throws InputError that names the panel
// if the outline is open, crosses itself, pinches the cloth to a point, is clockwise or has an edge of zero length, or
// if about more than max_triangles are needed.
PanelMesh triangulate(const Panel& panel, const std::vector<int>& segments, const TriangulateOptions& options = {});

}  // namespace selvedge::sim
