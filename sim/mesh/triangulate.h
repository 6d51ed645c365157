#pragma once
// One panel cut into triangles: constrained Delaunay of its sampled outline with interior points of our own placing.
// No point is ever added on the outline, or seams would no longer match.  (SPEC 3.1)
#include <vector>

#include "sim/mesh/panel_mesh.h"
#include "sim/pattern/pattern.h"

namespace selvedge {

struct TriangulateOptions {
    double target_edge = 0.05;   // m
    int relaxations = 12;        // rounds of moving interior points
    int max_triangles = 200000;  // of this panel
};

// segments: per outline edge, see count_segments(). The outline may touch itself from outside, along a slit of no
// width or in a point; both sides keep their own vertices.
// Throws InputError naming the panel when its outline is open, crosses itself, pinches the cloth to a point, runs
// clockwise or has an edge without length, or when more than max_triangles would be needed.
PanelMesh triangulate(const Panel& panel, const std::vector<int>& segments, const TriangulateOptions& options = {});

}  // namespace selvedge
