#pragma once
// Ways along the cloth of a sewn garment.
#include <cstddef>
#include <utility>
#include <vector>

#include "sim/mesh/garment_mesh.h"

namespace selvedge::sim {

// Per vertex: those with which it has an edge, and the cloth between, m. An edge of two triangles is there twice.
using ClothNeighbours = std::vector<std::vector<std::pair<std::size_t, double>>>;
ClothNeighbours cloth_neighbours(const GarmentMesh& mesh);

}  // namespace selvedge::sim
