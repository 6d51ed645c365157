#include "sim/repair/triangle_edges.h"

#include <algorithm>

namespace selvedge::sim {

std::vector<TriangleSide> sorted_sides(const std::vector<std::array<int, 3>>& triangles) {
    std::vector<TriangleSide> sides;
    sides.reserve(triangles.size() * 3);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
            sides.push_back({low, high, int(t), int(k)});
        }
    std::sort(sides.begin(), sides.end());
    return sides;
}

}  // namespace selvedge::sim
