#pragma once
// Self-intersections of a body's surface: pairs of triangles that pierce each other.
#include <array>
#include <vector>

#include "sim/body/body.h"

namespace selvedge::sim {

// All pairs of triangles in which an edge of one pierces the other. Each pair has the lower index first; the list is
// sorted. Triangles that share one vertex count if they meet anywhere else; triangles that share an edge, and mere
// contact, do not count. Computed in double precision: a contact within rounding error may be classified either way.
std::vector<std::array<int, 2>> self_intersections(const Body& body);

}  // namespace selvedge::sim
