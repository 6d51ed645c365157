#pragma once
// Limits how much coarser cloth may be than other cloth that it touches: by two levels, a factor of 4 in edge length.
// Otherwise many elements of the fine side meet one of the coarse side, which cannot follow them.
#include <algorithm>
#include <limits>
#include <vector>

#include "sim/adaptive/adaptive_mesh.h"

namespace selvedge::sim {

struct ContactLengthCriterion {
    // By vertex: the shortest edge that touches an element at the vertex, m (SelfContact::shortest_touching()).
    // Vertices beyond its end touch nothing.
    const std::vector<float>& touching;
    float ratio = 4;  // of the lengths of two edges that touch

    bool wants_split(const AdaptiveMesh& mesh, EdgeId e) const {
        return mesh.rest_length(e) > ratio * std::min(at(mesh.end(e, 0)), at(mesh.end(e, 1)));
    }
    bool allows_rejoin(const AdaptiveMesh& mesh, EdgeId e) const {
        return !wants_split(mesh, e) && mesh.rest_length(e) <= ratio * at(mesh.centre(e));
    }

 private:
    float at(VertexId v) const {
        return v.value < touching.size() ? touching[v.value] : std::numeric_limits<float>::max();
    }
};

}  // namespace selvedge::sim
