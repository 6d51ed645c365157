#pragma once
// Which diagonal a triangle gets when two of its edges are split and both diagonals conform. The default is the minimal
// change from the present configuration.  (thesis fig. 3.9; bench/thesis measures its alternatives)
#include "sim/core/math.h"
#include "sim/core/pool.h"

namespace selvedge::sim {

struct Diagonal {
    VertexId a, b;
    Vec2f u_a, u_b;  // m
};

// A choice has    float cost(const Diagonal&) const;    the lower cost wins; at equal cost the minimal change
struct MinimalChange {};

}  // namespace selvedge::sim
