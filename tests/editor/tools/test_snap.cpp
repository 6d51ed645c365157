#include "editor/tools/snap.h"

#include <gtest/gtest.h>

#include "tests/editor/tools/tool_support.h"

namespace selvedge::editor {
namespace {

class SnapTest : public ::testing::Test {
 protected:
    SnapTest() { geometry_.update(two_squares().pattern, 1); }

    Snap at(const Vec2d& wanted, const SnapOptions& options = {}) { return snap(geometry_, wanted, options); }

    SheetGeometry geometry_;
};

TEST_F(SnapTest, to_a_vertex_before_all_else) {
    const Snap snapped = at({0.203, 0.197});
    EXPECT_EQ(snapped.kind, SnapKind::Point);
    EXPECT_TRUE(snapped.point.isApprox(Vec2d(0.2, 0.2)));
}

TEST_F(SnapTest, to_the_middle_of_an_edge) {
    const Snap snapped = at({0.103, 0.002});
    EXPECT_EQ(snapped.kind, SnapKind::Midpoint);
    EXPECT_LT((snapped.point - Vec2d(0.1, 0)).norm(), 1e-12);
}

TEST_F(SnapTest, in_line_with_points_and_shows_the_line) {
    const Snap snapped = at({0.302, 0.317});
    EXPECT_EQ(snapped.kind, SnapKind::Guide);
    EXPECT_TRUE(snapped.point.isApprox(Vec2d(0.3, 0.32))) << "the other way it goes by the grid";
    ASSERT_EQ(snapped.guides.size(), 1U);
    EXPECT_TRUE(snapped.guides[0].from.isApprox(Vec2d(0.3, 0.2))) << "the nearest point of that line";
}

TEST_F(SnapTest, to_the_grid_where_nothing_else_is_near) {
    const Snap snapped = at({0.2531, 0.2688});
    EXPECT_EQ(snapped.kind, SnapKind::Grid);
    EXPECT_TRUE(snapped.point.isApprox(Vec2d(0.25, 0.27)));
}

TEST_F(SnapTest, not_at_all_when_it_is_off) {
    const Snap snapped = at({0.2013, 0.1991}, {.is_on = false});
    EXPECT_EQ(snapped.point, Vec2d(0.2013, 0.1991));
}

TEST_F(SnapTest, not_to_what_moves_along) {
    const SnapOptions options{.grid = 0, .to_guides = false, .moving = {{"left", 2}}};
    EXPECT_EQ(at({0.203, 0.197}, options).kind, SnapKind::None);
    EXPECT_EQ(at({0.203, 0.102}, options).kind, SnapKind::None) << "the middle of its edge moves, too";
    EXPECT_EQ(at({0.303, 0.197}, options).kind, SnapKind::Point);
}

TEST_F(SnapTest, to_eighths_of_a_turn) {
    const SnapOptions options{.to_directions = true, .origin = Vec2d(1, 1)};
    EXPECT_NEAR(at({1.5, 1.04}, options).point.y(), 1, 1e-12);
    const Vec2d diagonal = at({0.49, 0.46}, options).point;
    EXPECT_NEAR(diagonal.x(), diagonal.y(), 1e-12);
}

TEST_F(SnapTest, a_direction_ends_in_line_with_a_point) {
    const SnapOptions options{.to_directions = true, .origin = Vec2d(0, 0.5)};
    const Snap snapped = at({0.503, 0.51}, options);
    EXPECT_TRUE(snapped.point.isApprox(Vec2d(0.5, 0.5)));
    EXPECT_EQ(snapped.guides.size(), 2U);
}

TEST_F(SnapTest, along_an_edge_to_shares_and_to_millimetres) {
    const EdgeShape& edge = *geometry_.edge({"left", 0});
    EXPECT_DOUBLE_EQ(snap_along(edge, 0.505, {}), 0.5);
    EXPECT_DOUBLE_EQ(snap_along(edge, 0.335, {}), 1.0 / 3);
    EXPECT_DOUBLE_EQ(snap_along(edge, 0.1012, {}), 0.1);
    EXPECT_DOUBLE_EQ(snap_along(edge, 0.1012, {.is_on = false}), 0.1012);
}

}  // namespace
}  // namespace selvedge::editor
