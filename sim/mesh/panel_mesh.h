#pragma once
// One panel cut into triangles, in its own plane.  (SPEC 3.1)
#include <array>
#include <vector>

#include "sim/core/vec.h"

namespace selvedge {

// The stretch of the outline that came from one OutlineEdge: outline[first], outline[first+1], ..
// outline[first+segments] (indices modulo the outline's size).
struct OutlineRun {
    int first = 0;
    int segments = 0;
};

struct PanelMesh {
    std::vector<Vec2d> u;                       // material coordinates, m, held frame
    std::vector<std::array<int, 3>> triangles;  // counter-clockwise
    std::vector<int> outline;                   // vertices along the outline, counter-clockwise, each once
    std::vector<OutlineRun> runs;               // one per OutlineEdge of the panel, same order
};

}  // namespace selvedge
