#pragma once
// Validation of an adaptive mesh: pools, hierarchy, configurations, edge sides, adjacency, conformity, area and leaf
// lists. Each is recomputed from the stored elements, independently of the others.
#include <string>
#include <vector>

#include "sim/adaptive/adaptive_mesh.h"

namespace selvedge::sim {

// The broken invariants, each with its element; empty for a valid mesh. Pre: retriangulate() and refresh_lists() were
// called after the last split or rejoin.
std::vector<std::string> check(const AdaptiveMesh& mesh);

}  // namespace selvedge::sim
