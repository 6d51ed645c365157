#include "sim/inspection/cloth_neighbours.h"

namespace selvedge::sim {

ClothNeighbours cloth_neighbours(const GarmentMesh& mesh) {
    ClothNeighbours neighbours(mesh.x.size());
    for (const GarmentTriangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto a = static_cast<std::size_t>(t.vertices[k]);
            const auto b = static_cast<std::size_t>(t.vertices[(k + 1) % 3]);
            const double length = (t.u[k] - t.u[(k + 1) % 3]).norm();
            neighbours[a].emplace_back(b, length);
            neighbours[b].emplace_back(a, length);
        }
    }
    return neighbours;
}

}  // namespace selvedge::sim
