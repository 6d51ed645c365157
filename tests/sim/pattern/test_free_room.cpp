#include <gtest/gtest.h>

#include "sim/pattern/free_room.h"

namespace selvedge::sim {
namespace {

TEST(FreeRoom, stays_where_nothing_is) {
    EXPECT_EQ(nearest_free_move({}, MoveWay::Either), 0);
    EXPECT_EQ(nearest_free_move({{0, 2}, {-3, 0}}, MoveWay::Either), 0) << "the ends are free";
    EXPECT_EQ(nearest_free_move({{1, -1}}, MoveWay::Either), 0) << "an empty range takes nothing";
}

TEST(FreeRoom, goes_the_shorter_way_round_all_that_covers_it) {
    EXPECT_EQ(nearest_free_move({{-1, 2}}, MoveWay::Either), -1);
    EXPECT_EQ(nearest_free_move({{-1, 2}}, MoveWay::Forward), 2);
    EXPECT_EQ(nearest_free_move({{-2, 2}}, MoveWay::Either), 2);
    EXPECT_EQ(nearest_free_move({{1.5, 3}, {-4, -0.5}, {-1, 2}}, MoveWay::Either), 3);
    EXPECT_EQ(nearest_free_move({{2, 3}, {-1, 2}, {-9, -1}}, MoveWay::Forward), 2) << "between two that touch";
}

TEST(FreeRoom, keeps_the_gap) {
    const TakenMoves taken = moves_onto({.low = 0, .high = 1}, {.low = 0.5, .high = 3}, 0.25);
    EXPECT_EQ(taken.from, -0.75);
    EXPECT_EQ(taken.to, 3.25);
}

}  // namespace
}  // namespace selvedge::sim
