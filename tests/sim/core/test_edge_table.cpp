#include "sim/core/edge_table.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace selvedge::sim {
namespace {

// Two triangles that share the edge 1-2, and a third that stands on it.
const std::vector<std::array<int, 3>> kFan{{0, 1, 2}, {2, 1, 3}, {1, 2, 4}};

TEST(EdgeTable, lists_edges_in_the_order_of_their_vertices) {
    const EdgeTable<int> table(kFan);
    ASSERT_EQ(table.size(), 7U);
    std::vector<std::array<int, 2>> ends;
    for (const auto edge : table.edges()) ends.push_back({edge[0].low, edge[0].high});
    EXPECT_EQ(ends, (std::vector<std::array<int, 2>>{{0, 1}, {0, 2}, {1, 2}, {1, 3}, {1, 4}, {2, 3}, {2, 4}}));
}

TEST(EdgeTable, lists_all_sides_of_an_edge_in_the_order_of_the_triangles) {
    const EdgeTable<int> table(kFan);
    const auto crowded = table[2];
    ASSERT_EQ(crowded.size(), 3U);
    EXPECT_EQ(crowded[0].triangle, 0);
    EXPECT_EQ(crowded[1].triangle, 1);
    EXPECT_EQ(crowded[2].triangle, 2);
    EXPECT_TRUE(crowded[0].rises && !crowded[1].rises && crowded[2].rises);
}

TEST(EdgeTable, finds_the_corners_of_a_side_by_its_vertices) {
    const EdgeTable<int> table(kFan);
    for (const auto edge : table.edges()) {
        for (const TriangleSide<int>& side : edge) {
            const std::array<int, 3>& vertices = kFan[std::size_t(side.triangle)];
            EXPECT_EQ(vertices[std::size_t(side.corner(true))], side.low);
            EXPECT_EQ(vertices[std::size_t(side.corner(false))], side.high);
        }
    }
}

TEST(EdgeTable, is_empty_without_triangles) {
    EXPECT_EQ(EdgeTable<int>(std::vector<std::array<int, 3>>{}).size(), 0U);
}

}  // namespace
}  // namespace selvedge::sim
