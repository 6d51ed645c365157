#include "sim/inspection/cloth_neighbours.h"

#include <functional>
#include <queue>

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

std::map<std::size_t, double> distances_along(const ClothNeighbours& neighbours, std::span<const int> from,
                                              double most) {
    std::map<std::size_t, double> distances;
    using Reached = std::pair<double, std::size_t>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> next;
    const auto reach = [&](std::size_t v, double distance) {
        if (distance > most) return;
        const auto [known, is_new] = distances.try_emplace(v, distance);
        if (!is_new && known->second <= distance) return;
        known->second = distance;
        next.emplace(distance, v);
    };
    for (const int v : from) reach(static_cast<std::size_t>(v), 0);
    while (!next.empty()) {
        const auto [distance, v] = next.top();
        next.pop();
        if (distance > distances.at(v)) continue;
        for (const auto& [other, length] : neighbours[v]) reach(other, distance + length);
    }
    return distances;
}

}  // namespace selvedge::sim
