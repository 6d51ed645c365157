// The drawing tools: polygon, rectangle, ellipse, internal line, cut, mirror.
#include <gtest/gtest.h>

#include "sim/pattern/outline.h"
#include "tests/editor/tools/tool_support.h"

namespace selvedge::editor {
namespace {

class DrawTools : public ::testing::Test {
 protected:
    DrawTools() : hands_(sim::PatternDocument{}) {}

    const sim::Panel& made() { return hands_.pattern().panels.at(0); }

    SheetUser hands_;
};

TEST_F(DrawTools, a_polygon_closes_at_its_first_point) {
    hands_.choose("polygon");
    for (const Vec2d& at : {Vec2d(0, 0), Vec2d(0, 0.2), Vec2d(0.3, 0.2), Vec2d(0.002, 0.002)}) hands_.click(at);
    ASSERT_EQ(hands_.pattern().panels.size(), 1U);
    EXPECT_EQ(made().vertices.size(), 3U);
    EXPECT_NEAR(outline_area(made()), 0.03, 1e-9) << "counter-clockwise, though drawn clockwise";
    EXPECT_TRUE(hands_.vertex(made().name, 0).isZero(1e-9)) << "where it was drawn";
    EXPECT_GT(made().translation.z(), 0.2) << "before the body";
}

TEST_F(DrawTools, enter_closes_a_polygon_and_backspace_takes_a_point_back) {
    hands_.choose("polygon");
    for (const Vec2d& at : {Vec2d(0, 0), Vec2d(0.2, 0), Vec2d(0.2, 0.2), Vec2d(0.4, 0.25)}) hands_.click(at);
    EXPECT_TRUE(hands_.key(Key::Backspace));
    EXPECT_TRUE(hands_.key(Key::Enter));
    EXPECT_EQ(made().vertices.size(), 3U);
}

TEST_F(DrawTools, a_typed_length_sets_the_next_point_along_the_direction) {
    hands_.choose("polygon");
    hands_.click({0, 0});
    hands_.move({0.1, 0.004}, {.shift = true});
    hands_.type("92/4+1");
    hands_.click({0.2, 0.2});
    hands_.key(Key::Enter);
    EXPECT_TRUE(hands_.vertex(made().name, 1).isApprox(Vec2d(0.24, 0), 1e-9));
}

TEST_F(DrawTools, ctrl_puts_a_point_on_a_curve) {
    hands_.choose("polygon");
    hands_.click({0, 0});
    hands_.click({0.1, -0.05}, {.ctrl = true});
    for (const Vec2d& at : {Vec2d(0.2, 0), Vec2d(0.2, 0.2), Vec2d(0, 0.2)}) hands_.click(at);
    hands_.key(Key::Enter);
    ASSERT_EQ(made().vertices.size(), 4U);
    EXPECT_EQ(made().edges[0].kind, sim::CurveKind::Quadratic);
    EXPECT_TRUE((curve_point(made(), made().edges[0], 0.5) + *made().sheet_position).isApprox(Vec2d(0.1, -0.05), 1e-9));
}

TEST_F(DrawTools, escape_gives_a_polygon_up) {
    hands_.choose("polygon");
    hands_.click({0, 0});
    hands_.click({0.2, 0});
    EXPECT_TRUE(hands_.key(Key::Escape));
    EXPECT_FALSE(hands_.key(Key::Enter));
    EXPECT_TRUE(hands_.pattern().panels.empty());
    EXPECT_EQ(hands_.tools.info().id, "polygon");
}

TEST_F(DrawTools, two_points_are_no_panel_and_stay_drawn) {
    hands_.choose("polygon");
    hands_.click({0, 0});
    hands_.click({0.2, 0});
    hands_.key(Key::Enter);
    EXPECT_FALSE(hands_.message().empty());
    hands_.click({0.2, 0.2});
    hands_.key(Key::Enter);
    EXPECT_EQ(hands_.pattern().panels.size(), 1U);
}

TEST_F(DrawTools, a_rectangle_is_dragged_or_typed) {
    hands_.choose("rectangle");
    hands_.drag({0, 0}, {0.3, 0.2});
    EXPECT_NEAR(outline_area(made()), 0.06, 1e-9);
    hands_.click({0.4, 0});
    hands_.move({0.5, 0.1});
    EXPECT_FALSE(hands_.overlay().lines.empty());
    hands_.type("30 x 40");
    ASSERT_EQ(hands_.pattern().panels.size(), 2U);
    EXPECT_NEAR(outline_area(hands_.pattern().panels[1]), 0.12, 1e-9);
    EXPECT_TRUE(hands_.vertex(hands_.pattern().panels[1].name, 2).isApprox(Vec2d(0.7, 0.4), 1e-9));
}

TEST_F(DrawTools, a_rectangle_without_height_is_refused) {
    hands_.choose("rectangle");
    hands_.click({0, 0});
    hands_.type("30 x 0");
    EXPECT_TRUE(hands_.pattern().panels.empty());
    EXPECT_FALSE(hands_.message().empty());
}

TEST_F(DrawTools, an_ellipse_fills_its_box) {
    hands_.choose("ellipse");
    hands_.drag({0, 0}, {0.2, 0.2});
    EXPECT_NEAR(outline_area(made()), 3.14159265 * 0.01, 1e-4);
}

TEST(InternalLineTool, puts_its_line_into_the_panel_under_it) {
    SheetUser hands;
    hands.choose("internal_line");
    hands.click({0.35, 0.05});
    hands.click({0.45, 0.05});
    hands.key(Key::Enter);
    ASSERT_EQ(hands.panel("right").internal_lines.size(), 1U);
    EXPECT_TRUE(hands.panel("right").internal_lines[0].points[1].isApprox(Vec2d(0.15, 0.05), 1e-9));
}

TEST(InternalLineTool, says_that_a_line_beside_all_panels_belongs_to_none) {
    SheetUser hands;
    hands.choose("internal_line");
    hands.click({0.22, 0.05});
    hands.double_click({0.28, 0.05});
    EXPECT_FALSE(hands.message().empty());
    EXPECT_EQ(hands.document.position(), 0U);
}

TEST(CutTool, ends_at_the_second_edge_and_sews_the_cut) {
    SheetUser hands;
    hands.choose("cut");
    hands.click({0.05, 0.001});
    hands.click({0.05, 0.199});
    EXPECT_EQ(hands.pattern().panels.size(), 3U);
    EXPECT_EQ(hands.pattern().seams.size(), 1U);
}

TEST(CutTool, with_alt_leaves_the_cut_open) {
    SheetUser hands;
    hands.choose("cut");
    hands.click({0.05, 0.001});
    hands.click({0.05, 0.199}, {.alt = true});
    EXPECT_EQ(hands.pattern().panels.size(), 3U);
    EXPECT_TRUE(hands.pattern().seams.empty());
}

TEST(MirrorTool, mirrors_what_is_selected_over_two_clicks) {
    SheetUser hands;
    hands.drag({0.2, 0.2}, {0.2, 0.25}, {.ctrl = true});
    hands.click({0.1, 0.06});
    hands.choose("mirror");
    hands.click({0, -0.1});
    hands.click({0, 0.4}, {.shift = true});
    SheetBox box;
    for (int i = 0; i < 4; ++i) box.extend(hands.vertex("left", i));
    EXPECT_NEAR(box.min().x(), -0.2, 1e-9);
    EXPECT_NEAR(box.max().x(), 0, 1e-9);
    EXPECT_GT(outline_area(hands.panel("left")), 0);
}

}  // namespace
}  // namespace selvedge::editor
