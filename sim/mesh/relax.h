#pragma once
// Better triangles by moving, removing and adding interior points; the outline stays as it is.  (SPEC 3.1)
#include <array>
#include <span>
#include <vector>

#include "sim/core/vec.h"
#include "sim/mesh/interior_points.h"

namespace selvedge {

// A triangulation in the making: outline points first, then the interior ones.
struct PlanarMesh {
    std::vector<Vec2d> points;
    std::size_t outline_count = 0;
    std::vector<std::array<int, 3>> triangles;
};

// How bad the angles are: the sum over all triangles of the cubes of what their smallest angle lacks to 35 degrees, so
// that few bad ones weigh more than many fair ones.
double angle_penalty(const PlanarMesh& mesh);

// Moves each interior point to the centre of its neighbourhood (Lloyd), then sharp triangles' points to where their
// smallest angle is largest; after each round the mesh is triangulated anew. A round that does not lower the penalty
// is thrown away.
void relax(PlanarMesh& mesh, const SizeField& size, int rounds);

// Removes or adds single interior points at the worst triangles where that lowers the penalty.
void heal(PlanarMesh& mesh, const SizeField& size);

}  // namespace selvedge
