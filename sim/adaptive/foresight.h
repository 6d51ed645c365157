#pragma once
// Lets an edge speak for the finer edges beside it, which may not split before it does.
//
// Permissions let an edge split only between regular triangles (SPEC 1.2). In a straight fold the edges along the fold
// are flat and never ask, so that their triangles stay in S1..S6 and the fold stays at level 1, however much the edges
// across it ask. With foresight an edge also asks when a finer edge of its triangles does. It is a choice of the
// criterion, made outside of the mesh; the permissions stay as they are.
#include <algorithm>

#include "sim/adaptive/adapt.h"

namespace selvedge {

template <EdgeCriterion Criterion>
class Foresight {
 public:
    explicit Foresight(const Criterion& criterion) : criterion_(criterion) {}  // pre: outlives this

    bool wants_split(const AdaptiveMesh& mesh, EdgeId e) const {
        return criterion_.wants_split(mesh, e) || finer_edges_ask(mesh, e);
    }

    // Else what was split for others' sake would rejoin and split again, turn by turn.
    bool allows_rejoin(const AdaptiveMesh& mesh, EdgeId e) const {
        return criterion_.allows_rejoin(mesh, e) && !finer_edges_ask(mesh, e);
    }

 private:
    bool finer_edges_ask(const AdaptiveMesh& mesh, EdgeId e) const {
        if (mesh.level(e) + 1 >= mesh.max_level()) return false;
        const auto asks_inside = [&](TriangleId side) { return side && edges_inside_ask(mesh, mesh.triangle(side)); };
        const std::array<TriangleId, 2>& sides = mesh.edge(e).sides;
        return asks_inside(sides[0]) || asks_inside(sides[1]);
    }

    bool edges_inside_ask(const AdaptiveMesh& mesh, const AdaptiveTriangle& owner) const {
        const auto asks = [&](EdgeId e) {
            return mesh.level(e) > owner.level && !mesh.is_split(e) && criterion_.wants_split(mesh, e);
        };
        for (std::size_t i = 0; i < layout(owner.configuration).triangle_count; ++i) {
            const std::array<EdgeId, 3>& edges = mesh.triangle(owner.internal_triangles[i]).edges;
            if (std::any_of(edges.begin(), edges.end(), asks)) return true;
        }
        return false;
    }

    const Criterion& criterion_;
};

}  // namespace selvedge
