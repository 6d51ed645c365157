#pragma once
// Where a surface goes through itself.
#include <array>
#include <vector>

#include "sim/body/body.h"

namespace selvedge::sim {

// Pairs of triangles of which an edge of one pierces the other, the lower index first, ordered. Neighbours count when
// they meet elsewhere than in the vertex they share; two that share an edge do not, nor does mere touching. In double
// precision: a grazing contact within rounding may go either way.
std::vector<std::array<int, 2>> self_intersections(const Body& body);

}  // namespace selvedge::sim
