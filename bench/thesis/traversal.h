#pragma once
// A simulation step of the thesis' own kind, written once and run over the leaves in three ways: by recursion through
// the hierarchy, by temporary lists of the leaves, and by the flat lists that the adaptive mesh keeps.  (thesis 3.6.8,
// table 3.6)
//
// The step: springs and bending along all leaf edges, gravity, Verlet, and one correction of the length of all edges.
// It is a baseline for the cost of traversal, not the product's solver.
#include <vector>

#include "sim/adaptive/adaptive_mesh.h"
#include "sim/core/math.h"

namespace selvedge::bench {

struct SpringState {
    std::vector<Vec3f> x, x_prev, force;  // by VertexId; m, m, N
    std::vector<float> inverse_mass;      // 1/kg, by VertexId; 0: pinned
};

// At rest, at the given positions of the base vertices; each split edge's centre is the mean of its ends. Pinned: base
// vertices 0 and 1. Pre: as many positions as base vertices.
SpringState make_spring_state(const sim::AdaptiveMesh& mesh, const std::vector<Vec3d>& x);

// Leaves as ids, in the order of recursion.
struct TemporaryLists {
    std::vector<sim::VertexId> vertices;
    std::vector<sim::EdgeId> edges;
};

// Collects them by recursion. `lists` keeps its memory from call to call.
void collect_leaves(const sim::AdaptiveMesh& mesh, TemporaryLists& lists);

void step_by_recursion(const sim::AdaptiveMesh& mesh, SpringState& state);
void step_by_lists(const sim::AdaptiveMesh& mesh, const TemporaryLists& lists, SpringState& state);
void step_by_flat_lists(const sim::AdaptiveMesh& mesh, SpringState& state);  // mesh.leaf_edges(), hinges()

}  // namespace selvedge::bench
