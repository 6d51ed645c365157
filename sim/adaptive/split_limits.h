#pragma once
// How far splits may go.
#include <algorithm>

#include "sim/adaptive/adaptive_mesh.h"

namespace selvedge {

struct SplitLimits {
    float shortest_edge = 0;        // m, an edge shorter than this is not split
    int max_level = kDeepestLevel;  // nor one of this level, or of the mesh's own deepest

    bool allow(const AdaptiveMesh& mesh, EdgeId e) const {
        return mesh.level(e) < std::min(max_level, mesh.max_level()) && mesh.rest_length(e) >= shortest_edge;
    }

    bool operator==(const SplitLimits&) const = default;
};

}  // namespace selvedge
