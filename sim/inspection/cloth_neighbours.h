#pragma once
// Ways along the cloth of a sewn garment.
#include <cstddef>
#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "sim/mesh/garment_mesh.h"

namespace selvedge::sim {

// Per vertex: those with which it has an edge, and the cloth between, m. An edge of two triangles is there twice.
using ClothNeighbours = std::vector<std::vector<std::pair<std::size_t, double>>>;
ClothNeighbours cloth_neighbours(const GarmentMesh& mesh);

// The vertices within `most` of any of some, along edges, and how far it is to the nearest of these, m. (Dijkstra 1959)
std::map<std::size_t, double> distances_along(const ClothNeighbours& neighbours, std::span<const int> from,
                                              double most = std::numeric_limits<double>::infinity());

}  // namespace selvedge::sim
