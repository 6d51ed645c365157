#include "sim/body/triangle_edges.h"

#include <algorithm>
#include <numeric>

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

UnionFind::UnionFind(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
}

int UnionFind::find(int i) {
    while (parent_[std::size_t(i)] != i) {
        int& parent = parent_[std::size_t(i)];
        parent = parent_[std::size_t(parent)];
        i = parent;
    }
    return i;
}

void UnionFind::join(int a, int b) {
    const int root_a = find(a);
    const int root_b = find(b);
    parent_[std::size_t(std::max(root_a, root_b))] = std::min(root_a, root_b);
}

}  // namespace selvedge::sim
