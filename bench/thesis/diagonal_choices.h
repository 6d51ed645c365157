#pragma once
// The choices between two diagonals that the thesis tried beside the minimal change, and judged no better.  (fig. 3.9)
#include <functional>

#include "sim/adaptive/diagonal.h"
#include "sim/cloth/cloth.h"

namespace selvedge::bench {

enum class DiagonalChoice {
    MinimalChange,
    Length,      // shortest in 3D
    RestLength,  // shortest in material coordinates
    Curvature,   // along which the surface bends least
};

// For AdaptClothOptions::diagonal_cost. Empty for MinimalChange. The cloth must outlive it.
std::function<float(const sim::Diagonal&)> diagonal_cost(const sim::Cloth& cloth, DiagonalChoice choice);

}  // namespace selvedge::bench
