#pragma once
// Which diagonal a triangle takes when two of its edges are split and either would do. By default the one that is least
// work from where it stands; these others were tried by the thesis and judged no better.  (thesis fig. 3.9; SPEC 1.2)
#include <vector>

#include "sim/core/math.h"
#include "sim/core/pool.h"

namespace selvedge::sim {

struct Diagonal {
    VertexId a, b;
    Vec2f u_a, u_b;  // m
};

// A choice has    float cost(const Diagonal&) const;    the lower is taken, and where both are equal the least work
struct MinimalChange {};

// In the room. Position is any vector type whose first three coefficients are the position, m.
template <class Position>
struct ShortestDiagonal {
    const std::vector<Position>& x;

    float cost(const Diagonal& d) const {
        return (x[d.b.value].template head<3>() - x[d.a.value].template head<3>()).squaredNorm();
    }
};
template <class Position>
ShortestDiagonal(const std::vector<Position>&) -> ShortestDiagonal<Position>;

// In the material.
struct ShortestRestDiagonal {
    float cost(const Diagonal& d) const { return (d.u_b - d.u_a).squaredNorm(); }
};

// Along which the surface bends least. Normals are unit.
struct FlattestDiagonal {
    const std::vector<Vec3f>& normals;

    float cost(const Diagonal& d) const { return -normals[d.a.value].dot(normals[d.b.value]); }
};

}  // namespace selvedge::sim
