#pragma once
// Which diagonal a triangle gets when two of its edges are split and both diagonals conform. The default is the minimal
// change from the present configuration. The thesis tried these alternatives and judged them no better.  (fig. 3.9)
#include <vector>

#include "sim/core/math.h"
#include "sim/core/pool.h"

namespace selvedge::sim {

struct Diagonal {
    VertexId a, b;
    Vec2f u_a, u_b;  // m
};

// A choice has    float cost(const Diagonal&) const;    the lower cost wins; at equal cost the minimal change
struct MinimalChange {};

// Shortest in 3D. Position is any vector type whose first three coefficients are the position, m.
template <class Position>
struct ShortestDiagonal {
    const std::vector<Position>& x;

    float cost(const Diagonal& d) const {
        return (x[d.b.value].template head<3>() - x[d.a.value].template head<3>()).squaredNorm();
    }
};
template <class Position>
ShortestDiagonal(const std::vector<Position>&) -> ShortestDiagonal<Position>;

// Shortest in material coordinates.
struct ShortestRestDiagonal {
    float cost(const Diagonal& d) const { return (d.u_b - d.u_a).squaredNorm(); }
};

// The diagonal along which the surface bends least. Normals are unit vectors.
struct FlattestDiagonal {
    const std::vector<Vec3f>& normals;

    float cost(const Diagonal& d) const { return -normals[d.a.value].dot(normals[d.b.value]); }
};

}  // namespace selvedge::sim
