#include <gtest/gtest.h>
#include <limits>

#include "editor/tools/sheet_geometry.h"
#include "editor/tools/sheet_pick.h"
#include "editor/tools/snap.h"
#include "tests/editor/tools/tool_support.h"

namespace selvedge::editor {
namespace {

SheetGeometry geometry_of(const sim::Pattern& pattern) {
    SheetGeometry geometry;
    geometry.update(pattern, 1);
    return geometry;
}

sim::Pattern bent_pattern() {
    sim::Pattern pattern = two_squares().pattern;
    sim::OutlineEdge& edge = pattern.panels[0].edges[0];
    edge.kind = sim::CurveKind::Cubic;
    edge.control = {Vec2d(0.05, -0.05), Vec2d(0.15, -0.05)};
    pattern.panels[0].notches.push_back({.edge = 2, .t = 0.25});
    pattern.panels[0].internal_lines.push_back({.name = "fold", .points = {Vec2d(0.02, 0.1), Vec2d(0.18, 0.1)}});
    return pattern;
}

TEST(SheetPick, small_things_come_before_what_they_lie_on) {
    const SheetGeometry geometry = geometry_of(bent_pattern());
    const auto kind_at = [&](const Vec2d& at) { return pick(geometry, at, {}).kind; };
    EXPECT_EQ(kind_at({0.001, 0.199}), PickKind::Vertex);
    EXPECT_EQ(kind_at({0.15, 0.201}), PickKind::Notch) << "edge 2 runs from right to left";
    EXPECT_EQ(kind_at({0.08, 0.202}), PickKind::Edge);
    EXPECT_EQ(kind_at({0.08, 0.102}), PickKind::InternalLine);
    EXPECT_EQ(kind_at({0.08, 0.15}), PickKind::Panel);
    EXPECT_EQ(kind_at({0.25, 0.1}), PickKind::Nothing);
}

TEST(SheetPick, handles_are_picked_where_they_are_shown) {
    const SheetGeometry geometry = geometry_of(bent_pattern());
    EXPECT_EQ(pick(geometry, {0.15, -0.05}, {}).kind, PickKind::Nothing);
    const Pick picked = pick(geometry, {0.15, -0.05}, {.handle_edges = {{"left", 0}}});
    EXPECT_EQ(picked.kind, PickKind::Handle);
    EXPECT_EQ(picked.control, 1);
}

TEST(SheetPick, an_edge_is_picked_at_a_fraction_of_its_length) {
    const SheetGeometry geometry = geometry_of(two_squares().pattern);
    const Pick picked = pick(geometry, {0.35, 0.003}, {});
    EXPECT_EQ(picked.panel, "right");
    EXPECT_EQ(picked.index, 0);
    EXPECT_NEAR(picked.t, 0.25, 1e-12);
    EXPECT_NEAR(picked.point.y(), 0, 1e-12);
}

TEST(SheetPick, of_panels_that_overlap_the_one_drawn_last_is_picked) {
    sim::Pattern pattern = two_squares().pattern;
    pattern.panels[1].sheet_position = Vec2d(0.1, 0.05);
    EXPECT_EQ(pick(geometry_of(pattern), {0.15, 0.1}, {}).panel, "right");
}

TEST(SheetPick, hidden_and_locked_panels_are_passed_over) {
    sim::Pattern pattern = bent_pattern();
    pattern.panels[1].sheet_position = Vec2d(0.1, 0.05);
    SheetGeometry geometry;
    const PanelStates hidden{.hidden = {"right"}, .locked = {}}, locked{.hidden = {}, .locked = {"right"}};
    const SheetBox all(Vec2d(-1, -1), Vec2d(1, 1));
    for (const PanelStates& states : {hidden, locked}) {
        geometry.update(pattern, 1, states);
        EXPECT_EQ(pick(geometry, {0.15, 0.12}, {}).panel, "left") << "what lies under it";
        EXPECT_EQ(pick(geometry, {0.3, 0.25}, {}).kind, PickKind::Nothing) << "its corner";
        EXPECT_EQ(in_box(geometry, all, BoxRule::Inside, BoxTargets::Panels).panels, std::set<std::string>{"left"});
        EXPECT_EQ(in_box(geometry, all, BoxRule::Inside, BoxTargets::Vertices).vertices.size(), 4U);
        EXPECT_EQ(in_box(geometry, all, BoxRule::Inside, BoxTargets::Edges).edges.size(), 4U);
    }
    geometry.update(pattern, 1, {.hidden = {}, .locked = {"left"}});
    EXPECT_EQ(pick(geometry, {0.15, -0.05}, {.handle_edges = {{"left", 0}}}).kind, PickKind::Nothing) << "its handle";
    geometry.update(pattern, 1, {});
    EXPECT_EQ(pick(geometry, {0.15, 0.12}, {}).panel, "right");
}

TEST(SheetPick, hovering_an_edge_names_its_seam) {
    sim::Pattern pattern = two_squares().pattern;
    pattern.seams.push_back({{0, 1}, {1, 3}});
    const SheetGeometry geometry = geometry_of(pattern);
    const Hover hover = hover_of(geometry, pick(geometry, {0.2, 0.1}, {}));
    EXPECT_EQ(hover.edge, (PartRef{"left", 1}));
    EXPECT_EQ(hover.seam, 0);
    EXPECT_EQ(hover.panel, "left");
}

TEST(SheetPick, a_box_takes_what_is_inside_or_what_it_touches) {
    const SheetGeometry geometry = geometry_of(two_squares().pattern);
    const SheetBox box(Vec2d(-0.1, -0.1), Vec2d(0.4, 0.3));
    EXPECT_EQ(in_box(geometry, box, BoxRule::Inside, BoxTargets::Panels).panels, (std::set<std::string>{"left"}));
    EXPECT_EQ(in_box(geometry, box, BoxRule::Touching, BoxTargets::Panels).panels,
              (std::set<std::string>{"left", "right"}));
    EXPECT_EQ(in_box(geometry, box, BoxRule::Inside, BoxTargets::Vertices).vertices.size(), 6U);
    EXPECT_EQ(in_box(geometry, box, BoxRule::Inside, BoxTargets::Edges).edges.size(), 5U);
}

TEST(SheetPick, a_box_within_a_panel_touches_it) {
    const SheetGeometry geometry = geometry_of(two_squares().pattern);
    const SheetBox box(Vec2d(0.05, 0.05), Vec2d(0.06, 0.06));
    EXPECT_EQ(in_box(geometry, box, BoxRule::Touching, BoxTargets::Panels).panels.size(), 1U);
    EXPECT_TRUE(in_box(geometry, box, BoxRule::Touching, BoxTargets::Edges).is_empty());
}

TEST(SheetGeometry, keeps_the_outlines_of_panels_that_only_moved) {
    sim::Pattern pattern = two_squares().pattern;
    SheetGeometry geometry;
    geometry.update(pattern, 1);
    const std::uint64_t version = geometry.panels()[0].outline_version;
    pattern.panels[0].sheet_position = Vec2d(-0.5, 0);
    geometry.update(pattern, 2);
    EXPECT_EQ(geometry.panels()[0].outline_version, version);
    EXPECT_NEAR(geometry.vertex({"left", 0})->x(), -0.5, 1e-12);
    pattern.panels[0].vertices[0].x() -= 0.01;
    geometry.update(pattern, 3);
    EXPECT_NE(geometry.panels()[0].outline_version, version);
}

TEST(SheetGeometry, points_of_a_curve_lie_at_fractions_of_its_length) {
    const SheetGeometry geometry = geometry_of(bent_pattern());
    const EdgeShape& edge = *geometry.edge({"left", 0});
    EXPECT_NEAR(edge.at(0.5).x(), 0.1, 1e-6);
    EXPECT_NEAR(edge.at(0.5).y(), -0.0375, 1e-4);
    EXPECT_NEAR(nearest(edge, {0.1, -0.2}).t, 0.5, 1e-4);
    EXPECT_NEAR(edge.tangent(0.5).x(), 1, 1e-3);
}

}  // namespace

namespace {

TEST(SheetCamera, a_place_goes_to_the_screen_and_back) {
    const SheetCamera camera{.centre = {0.3, -0.2}, .scale = 750, .view_low = {40, 60}, .view_size = {800, 500}};
    EXPECT_TRUE(to_px(camera, camera.centre).isApprox(Vec2d(440, 310)));
    EXPECT_GT(to_px(camera, {0.3, -0.3}).y(), 310) << "y is up on the sheet and down on the screen";
    EXPECT_TRUE(to_sheet(camera, to_px(camera, {0.123, 0.456})).isApprox(Vec2d(0.123, 0.456)));
}

TEST(SheetCamera, zooming_keeps_what_is_under_the_cursor) {
    SheetCamera camera;
    const Vec2d cursor(123, 456), held = to_sheet(camera, cursor);
    zoom_at(camera, cursor, 3);
    EXPECT_GT(camera.scale, SheetCamera{}.scale);
    EXPECT_LT((to_sheet(camera, cursor) - held).norm(), 1e-12);
}

TEST(SheetCamera, zooming_has_limits) {
    SheetCamera camera;
    for (int i = 0; i < 100; ++i) zoom_at(camera, {100, 100}, 50);
    EXPECT_EQ(camera.scale, kMaxSheetScale);
    for (int i = 0; i < 100; ++i) zoom_at(camera, {100, 100}, -50);
    EXPECT_EQ(camera.scale, kMinSheetScale);
    zoom_at(camera, {100, 100}, std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(camera.scale, kMinSheetScale);
}

TEST(SheetCamera, a_framed_box_is_seen_whole_within_its_margin) {
    SheetCamera camera;
    const SheetBox box(Vec2d(1, 2), Vec2d(1.5, 4));
    frame(camera, box, 30);
    const Vec2d low = to_px(camera, {1, 4}), high = to_px(camera, {1.5, 2});
    EXPECT_NEAR(low.y(), 30, 1e-9);
    EXPECT_NEAR(high.y(), camera.view_size.y() - 30, 1e-9);
    EXPECT_GE(low.x(), 30);
}

TEST(SheetCamera, nothing_is_framed_by_an_empty_box) {
    SheetCamera camera;
    const SheetCamera before = camera;
    frame(camera, SheetBox(), 30);
    EXPECT_EQ(camera, before);
}

TEST(SheetCamera, the_grid_grows_coarser_as_one_goes_away) {
    SheetCamera camera;
    camera.scale = 10000;
    EXPECT_EQ(grid_step(camera, 6), 0.001);
    camera.scale = 1000;
    EXPECT_EQ(grid_step(camera, 6), 0.01);
    camera.scale = 20;
    EXPECT_EQ(grid_step(camera, 6), 0.5);
}

}  // namespace

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

TEST_F(SnapTest, not_to_points_of_hidden_panels) {
    const sim::Pattern pattern = two_squares().pattern;
    SheetGeometry geometry;
    geometry.update(pattern, 1, {.hidden = {}, .locked = {"right"}});
    EXPECT_EQ(snap(geometry, {0.302, 0.199}, {}).kind, SnapKind::Point) << "a locked panel is seen";
    geometry.update(pattern, 1, {.hidden = {"right"}, .locked = {}});
    EXPECT_NE(snap(geometry, {0.302, 0.199}, {}).kind, SnapKind::Point);
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
