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

// Constrained Delaunay triangulation of the inside of an outline (CGAL's Constrained_Delaunay_triangulation_2).
// Vertices 0..outline.size()-1 are the outline, counter-clockwise; the interior vertices follow. No vertex is added.
// The outline may touch itself where points coincide exactly, for example along a slit. CGAL has one point there, but
// the result keeps separate vertices, each with the triangles on its side of the slit. Each triangle starts with its
// lowest vertex and triangles are sorted, so that the result does not depend on CGAL's order. Returns nullopt if the
// outline has no inside on its left, if the inside is pinched in a point, or if an interior point is on the outline or
// coincides with another point. Pre: find_crossing(outline) is empty.
std::optional<std::vector<std::array<int, 3>>> delaunay_inside(std::span<const Vec2d> outline,
                                                               std::span<const Vec2d> interior);

}  // namespace selvedge::sim
