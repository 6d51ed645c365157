#pragma once
// Whether an adaptive mesh is sound: pools, hierarchy, configurations, sides, adjacency, conformity, area and lists,
// each looked at from the ids up and without trusting the others.  (SPEC 1.1, 1.2)
#include <string>
#include <vector>

#include "sim/adaptive/adaptive_mesh.h"

namespace selvedge::sim {

// The broken invariants, each naming its element; empty for a sound mesh. No pass may be half done.
std::vector<std::string> check(const AdaptiveMesh& mesh);

}  // namespace selvedge::sim
