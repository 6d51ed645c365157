#pragma once
// The edges of a triangle soup, with the triangles that meet at each.
#include <array>
#include <compare>
#include <vector>

namespace selvedge::sim {

// Side k of a triangle runs from corner k to corner k + 1.
struct TriangleSide {
    int low = 0;  // its vertices
    int high = 0;
    int triangle = 0;
    int k = 0;
    auto operator<=>(const TriangleSide&) const = default;
    bool same_edge(const TriangleSide& other) const { return low == other.low && high == other.high; }
};

// All sides, sorted, so that those of an undirected edge are adjacent.
std::vector<TriangleSide> sorted_sides(const std::vector<std::array<int, 3>>& triangles);

}  // namespace selvedge::sim
