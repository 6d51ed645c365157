// The drawing tools: polygon, rectangle, ellipse, internal line, cut, mirror.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

#include "sim/pattern/outline.h"
#include "tests/editor/tools/tool_support.h"

namespace selvedge::editor {
namespace {

class DrawTools : public ::testing::Test {
 protected:
    DrawTools() : user_(sim::PatternDocument{}) {}

    const sim::Panel& made() { return user_.pattern().panels.at(0); }

    SheetUser user_;
};

TEST_F(DrawTools, a_polygon_closes_at_its_first_point) {
    user_.choose("polygon");
    for (const Vec2d& at : {Vec2d(0, 0), Vec2d(0, 0.2), Vec2d(0.3, 0.2), Vec2d(0.002, 0.002)}) user_.click(at);
    ASSERT_EQ(user_.pattern().panels.size(), 1U);
    EXPECT_EQ(made().vertices.size(), 3U);
    EXPECT_NEAR(outline_area(made()), 0.03, 1e-9) << "counter-clockwise, though drawn clockwise";
    EXPECT_TRUE(user_.vertex(made().name, 0).isZero(1e-9)) << "where it was drawn";
    EXPECT_GT(made().translation.z(), 0.2) << "before the body";
}

TEST_F(DrawTools, enter_closes_a_polygon_and_backspace_takes_a_point_back) {
    user_.choose("polygon");
    for (const Vec2d& at : {Vec2d(0, 0), Vec2d(0.2, 0), Vec2d(0.2, 0.2), Vec2d(0.4, 0.25)}) user_.click(at);
    EXPECT_TRUE(user_.key(Key::Backspace));
    EXPECT_TRUE(user_.key(Key::Enter));
    EXPECT_EQ(made().vertices.size(), 3U);
}

TEST_F(DrawTools, a_typed_length_sets_the_next_point_along_the_direction) {
    user_.choose("polygon");
    user_.click({0, 0});
    user_.move({0.1, 0.004}, {.shift = true});
    user_.type("92/4+1");
    user_.click({0.2, 0.2});
    user_.key(Key::Enter);
    EXPECT_TRUE(user_.vertex(made().name, 1).isApprox(Vec2d(0.24, 0), 1e-9));
}

TEST_F(DrawTools, ctrl_puts_a_point_on_a_curve) {
    user_.choose("polygon");
    user_.click({0, 0});
    user_.click({0.1, -0.05}, {.ctrl = true});
    for (const Vec2d& at : {Vec2d(0.2, 0), Vec2d(0.2, 0.2), Vec2d(0, 0.2)}) user_.click(at);
    user_.key(Key::Enter);
    ASSERT_EQ(made().vertices.size(), 4U);
    EXPECT_EQ(made().edges[0].kind, sim::CurveKind::Quadratic);
    EXPECT_TRUE((curve_point(made(), made().edges[0], 0.5) + *made().sheet_position).isApprox(Vec2d(0.1, -0.05), 1e-9));
}

TEST_F(DrawTools, escape_gives_a_polygon_up) {
    user_.choose("polygon");
    user_.click({0, 0});
    user_.click({0.2, 0});
    EXPECT_TRUE(user_.key(Key::Escape));
    EXPECT_FALSE(user_.key(Key::Enter));
    EXPECT_TRUE(user_.pattern().panels.empty());
    EXPECT_EQ(user_.tools.info().id, "polygon");
}

TEST_F(DrawTools, two_points_are_no_panel_and_stay_drawn) {
    user_.choose("polygon");
    user_.click({0, 0});
    user_.click({0.2, 0});
    user_.key(Key::Enter);
    EXPECT_FALSE(user_.message().empty());
    user_.click({0.2, 0.2});
    user_.key(Key::Enter);
    EXPECT_EQ(user_.pattern().panels.size(), 1U);
}

TEST_F(DrawTools, a_rectangle_is_dragged_or_typed) {
    user_.choose("rectangle");
    user_.drag({0, 0}, {0.3, 0.2});
    EXPECT_NEAR(outline_area(made()), 0.06, 1e-9);
    user_.click({0.4, 0});
    user_.move({0.5, 0.1});
    EXPECT_FALSE(user_.overlay().lines.empty());
    user_.type("30 x 40");
    ASSERT_EQ(user_.pattern().panels.size(), 2U);
    EXPECT_NEAR(outline_area(user_.pattern().panels[1]), 0.12, 1e-9);
    EXPECT_TRUE(user_.vertex(user_.pattern().panels[1].name, 2).isApprox(Vec2d(0.7, 0.4), 1e-9));
}

TEST_F(DrawTools, a_rectangle_without_height_is_refused) {
    user_.choose("rectangle");
    user_.click({0, 0});
    user_.type("30 x 0");
    EXPECT_TRUE(user_.pattern().panels.empty());
    EXPECT_FALSE(user_.message().empty());
}

TEST_F(DrawTools, an_ellipse_fills_its_box) {
    user_.choose("ellipse");
    user_.drag({0, 0}, {0.2, 0.2});
    EXPECT_NEAR(outline_area(made()), 3.14159265 * 0.01, 1e-4);
}

TEST(InternalLineTool, puts_its_line_into_the_panel_under_it) {
    SheetUser user;
    user.choose("internal_line");
    user.click({0.35, 0.05});
    user.click({0.45, 0.05});
    user.key(Key::Enter);
    ASSERT_EQ(user.panel("right").internal_lines.size(), 1U);
    EXPECT_TRUE(user.panel("right").internal_lines[0].points[1].isApprox(Vec2d(0.15, 0.05), 1e-9));
}

TEST(InternalLineTool, says_that_a_line_beside_all_panels_belongs_to_none) {
    SheetUser user;
    user.choose("internal_line");
    user.click({0.22, 0.05});
    user.double_click({0.28, 0.05});
    EXPECT_FALSE(user.message().empty());
    EXPECT_EQ(user.document.position(), 0U);
}

TEST(CutTool, ends_at_the_second_edge_and_sews_the_cut) {
    SheetUser user;
    user.choose("cut");
    user.click({0.05, 0.001});
    user.click({0.05, 0.199});
    EXPECT_EQ(user.pattern().panels.size(), 3U);
    EXPECT_EQ(user.pattern().seams.size(), 1U);
}

TEST(CutTool, begins_at_the_tip_of_a_dart) {
    SheetUser user;
    user.document.run(AddDart{.panel = "left", .edge = 0, .t = 0.5, .width = 0.02, .depth = 0.08});
    user.choose("cut");
    user.click({0.102, 0.083});  // beside the tip, at (0.1, 0.08)
    user.click({0.05, 0.199});
    ASSERT_EQ(user.pattern().panels.size(), 3U) << user.message();
    const sim::Panel& cut = user.panel("left");
    const bool has_tip = std::ranges::any_of(cut.vertices, [&](const Vec2d& vertex) {
        return (vertex + *cut.sheet_position - Vec2d(0.1, 0.08)).norm() < 1e-9;
    });
    EXPECT_TRUE(has_tip);
    const auto count = [&](const std::string& name) { return user.panel(name).vertices.size(); };
    EXPECT_EQ(count("left") + count("left_2"), 7U + 1 + 2) << "no second point beside the tip";
}

TEST(CutTool, ends_at_a_corner) {
    SheetUser user;
    user.choose("cut");
    user.click({0.003, 0.004});
    user.click({0.196, 0.197});
    ASSERT_EQ(user.pattern().panels.size(), 3U) << user.message();
    EXPECT_EQ(user.panel("left").vertices.size(), 3U);
    EXPECT_EQ(user.panel("left_2").vertices.size(), 3U);
}

TEST(CutTool, that_leaves_the_panel_says_what_to_do) {
    SheetUser user;
    user.choose("cut");
    user.click({0.05, 0.001});
    user.click({0.1, -0.1}, {.ctrl = true});
    user.click({0.15, 0.001});
    EXPECT_EQ(user.pattern().panels.size(), 2U);
    EXPECT_NE(user.message().find("click"), std::string::npos) << user.message();
}

TEST(PathTools, take_a_length_with_its_angle_and_both_its_parts) {
    SheetUser user{sim::PatternDocument{}};
    user.choose("polygon");
    user.move({0.3, 0.3});
    user.type("10 x 20");  // the first point's place
    user.type("12 < 30");
    user.type("-5 x 8");
    user.key(Key::Enter);
    ASSERT_EQ(user.pattern().panels.size(), 1U) << user.message();
    const std::string name = user.pattern().panels[0].name;
    const Vec2d first(0.1, 0.2), second = first + 0.12 * Vec2d(std::sqrt(3) / 2, 0.5);
    EXPECT_TRUE(user.vertex(name, 0).isApprox(first, 1e-9)) << user.vertex(name, 0).transpose();
    EXPECT_TRUE(user.vertex(name, 1).isApprox(second, 1e-9)) << user.vertex(name, 1).transpose();
    EXPECT_TRUE(user.vertex(name, 2).isApprox(second + Vec2d(-0.05, 0.08), 1e-9));
}

TEST(CutTool, with_alt_leaves_the_cut_open) {
    SheetUser user;
    user.choose("cut");
    user.click({0.05, 0.001});
    user.click({0.05, 0.199}, {.alt = true});
    EXPECT_EQ(user.pattern().panels.size(), 3U);
    EXPECT_TRUE(user.pattern().seams.empty());
}

TEST(MirrorTool, mirrors_what_is_selected_over_two_clicks) {
    SheetUser user;
    user.drag({0.2, 0.2}, {0.2, 0.25}, {.ctrl = true});
    user.click({0.1, 0.06});
    user.choose("mirror");
    user.click({0, -0.1});
    user.click({0, 0.4}, {.shift = true});
    SheetBox box;
    for (int i = 0; i < 4; ++i) box.extend(user.vertex("left", i));
    EXPECT_NEAR(box.min().x(), -0.2, 1e-9);
    EXPECT_NEAR(box.max().x(), 0, 1e-9);
    EXPECT_GT(outline_area(user.panel("left")), 0);
}

}  // namespace
}  // namespace selvedge::editor
