#include "editor/tools/sheet_pick.h"

#include <gtest/gtest.h>

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
    pattern.panels[0].internal_lines.push_back({"fold", {Vec2d(0.02, 0.1), Vec2d(0.18, 0.1)}});
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
}  // namespace selvedge::editor
