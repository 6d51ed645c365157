#include <gtest/gtest.h>
#include <numbers>

#include "editor/geometry/outline_edit.h"
#include "editor/geometry/seam_edit.h"
#include "sim/pattern/edge_shape.h"
#include "tests/editor/geometry/geometry_support.h"

namespace selvedge::editor {
namespace {

// A square whose bottom edge is a curve of the given kind, below the straight line.
sim::Panel bottomed(sim::CurveKind kind) {
    sim::Panel panel = unit_square();
    sim::OutlineEdge& edge = panel.edges[0];
    edge.kind = kind;
    if (kind == sim::CurveKind::Quadratic) edge.control[0] = {0.2, -0.5};
    if (kind == sim::CurveKind::Cubic) edge.control = {Vec2d(0.1, -0.4), Vec2d(0.5, -0.3)};
    if (kind == sim::CurveKind::Arc) edge.arc_radius = 0.6;
    return panel;
}

sim::Pattern of(sim::Panel panel) {
    sim::Pattern pattern;
    pattern.panels.push_back(std::move(panel));
    return pattern;
}

TEST(SplitEdge, leaves_every_kind_of_curve_where_it_was) {
    for (const sim::CurveKind kind :
         {sim::CurveKind::Line, sim::CurveKind::Quadratic, sim::CurveKind::Cubic, sim::CurveKind::Arc}) {
        for (const double t : {0.3, 0.5, 0.9}) {
            const sim::Panel whole = bottomed(kind);
            sim::Pattern pattern = of(whole);
            EXPECT_EQ(split_edge(pattern, {0, 0}, t), 4);
            const double length = outline_length(whole, whole.edges[0]);
            EXPECT_NEAR(edge_length(pattern, {0, 0}), t * length, 1e-8);
            EXPECT_NEAR(edge_length(pattern, {0, 1}), (1 - t) * length, 1e-8);
            EXPECT_EQ(pattern.panels[0].edges[0].kind, kind);
            for (const double s : {0.25, 0.5, 0.75}) {
                EXPECT_NEAR((edge_point(pattern, {0, 0}, s) - outline_point(whole, whole.edges[0], s * t)).norm(), 0,
                            1e-7);
                EXPECT_NEAR(
                    (edge_point(pattern, {0, 1}, s) - outline_point(whole, whole.edges[0], t + s * (1 - t))).norm(), 0,
                    1e-7);
            }
        }
    }
}

TEST(SplitEdge, a_large_arc_falls_into_arcs_of_its_circle) {
    sim::Panel panel = bottomed(sim::CurveKind::Arc);
    panel.edges[0].is_large_arc = true;
    sim::Pattern pattern = of(panel);
    split_edge(pattern, {0, 0}, 0.8);
    const std::vector<sim::OutlineEdge>& edges = pattern.panels[0].edges;
    EXPECT_TRUE(edges[0].is_large_arc);
    EXPECT_FALSE(edges[1].is_large_arc);
    EXPECT_NEAR(outline_area(pattern.panels[0]), outline_area(panel), 1e-3);
}

TEST(SplitEdge, splits_the_other_side_of_its_seam_where_it_meets) {
    for (const bool is_reversed : {true, false}) {
        sim::Pattern pattern = two_squares();
        pattern.seams[0].is_reversed = is_reversed;
        pattern.seams[0].is_eased = true;
        split_edge(pattern, {0, 1}, 0.2);
        ASSERT_EQ(pattern.seams.size(), 2U);
        const sim::Seam& first = pattern.seams[0];
        const sim::Seam& second = pattern.seams[1];
        EXPECT_EQ(first, (sim::Seam{.first = {0, 1},
                                    .second = {1, is_reversed ? 4 : 3},
                                    .is_reversed = is_reversed,
                                    .name = "middle",
                                    .is_eased = true}));
        EXPECT_EQ(
            second,
            (sim::Seam{
                .first = {0, 2}, .second = {1, is_reversed ? 3 : 4}, .is_reversed = is_reversed, .is_eased = true}));
        EXPECT_NEAR(edge_length(pattern, first.first), 0.2, 1e-12);
        EXPECT_NEAR(edge_length(pattern, first.second), 0.2, 1e-12);
        EXPECT_NEAR(edge_length(pattern, second.second), 0.8, 1e-12);
    }
}

TEST(SplitEdge, seams_notches_and_pins_behind_it_follow) {
    sim::Pattern pattern = two_squares();
    pattern.panels[0].notches = {{.edge = 0, .t = 0.1}, {.edge = 0, .t = 0.7}, {.edge = 2, .t = 0.3}};
    pattern.panels[0].pins = {1};
    split_edge(pattern, {0, 0}, 0.4);
    EXPECT_EQ(pattern.seams[0].first, (sim::SeamSide{0, 2}));
    EXPECT_EQ(pattern.seams[0].second, (sim::SeamSide{1, 3}));
    const std::vector<sim::Notch>& notches = pattern.panels[0].notches;
    ASSERT_EQ(notches.size(), 3U);
    EXPECT_EQ(notches[0].edge, 0);
    EXPECT_NEAR(notches[0].t, 0.25, 1e-12);
    EXPECT_EQ(notches[1].edge, 1);
    EXPECT_NEAR(notches[1].t, 0.5, 1e-12);
    EXPECT_EQ(notches[2], (sim::Notch{.edge = 3, .t = 0.3}));
    EXPECT_EQ(pattern.panels[0].pins, std::vector<int>{1});
}

TEST(SplitEdge, splits_a_panel_that_is_sewn_to_itself) {
    sim::Pattern pattern = of(unit_square());
    pattern.seams = {{{0, 3}, {0, 1}}};
    split_edge(pattern, {0, 3}, 0.25);
    ASSERT_EQ(pattern.seams.size(), 2U);
    for (const sim::Seam& seam : pattern.seams) {
        EXPECT_NEAR(edge_length(pattern, seam.first), edge_length(pattern, seam.second), 1e-12);
        EXPECT_NEAR(edge_point(pattern, seam.first, 0).y(), edge_point(pattern, seam.second, 1).y(), 1e-12);
    }
}

TEST(SplitEdge, refuses_what_is_no_place_and_changes_nothing) {
    sim::Pattern pattern = two_squares();
    const sim::Pattern before = pattern;
    for (const double t : {0.0, 1.0, -1.0, 2.0, 1e-7, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_THROW(split_edge(pattern, {0, 1}, t), GeometryError) << t;
    }
    EXPECT_THROW(split_edge(pattern, {0, 4}, 0.5), GeometryError);
    EXPECT_THROW(split_edge(pattern, {2, 0}, 0.5), GeometryError);
    EXPECT_THROW(split_edge(pattern, {0, -1}, 0.5), GeometryError);
    EXPECT_TRUE(pattern == before);
}

TEST(RemoveVertices, takes_back_a_split_with_the_seam_across_it) {
    for (const bool is_reversed : {true, false}) {
        const sim::Pattern whole = [&] {
            sim::Pattern pattern = two_squares();
            pattern.seams[0].is_reversed = is_reversed;
            return pattern;
        }();
        sim::Pattern pattern = whole;
        remove_vertices(pattern, 0, {split_edge(pattern, {0, 1}, 0.3)});
        EXPECT_TRUE(pattern == whole);
    }
}

TEST(RemoveVertices, gives_back_the_curve_that_was_split) {
    for (const sim::CurveKind kind : {sim::CurveKind::Quadratic, sim::CurveKind::Cubic, sim::CurveKind::Arc}) {
        const sim::Panel whole = bottomed(kind);
        sim::Pattern pattern = of(whole);
        remove_vertices(pattern, 0, {split_edge(pattern, {0, 0}, 0.4)});
        ASSERT_EQ(pattern.panels[0].edges.size(), 4U);
        EXPECT_EQ(pattern.panels[0].edges[0].kind, kind);
        for (const double t : {0.2, 0.5, 0.8}) {
            EXPECT_NEAR((edge_point(pattern, {0, 0}, t) - outline_point(whole, whole.edges[0], t)).norm(), 0, 1e-7);
        }
    }
}

TEST(RemoveVertices, curves_of_different_kinds_become_a_cubic_near_them_with_their_end_tangents) {
    sim::Panel panel = make_polygon({{0, 0}, {0.5, -0.2}, {1, 0}, {1, 1}, {0, 1}});
    panel.edges[0].kind = sim::CurveKind::Quadratic;
    panel.edges[0].control[0] = {0.2, -0.2};
    panel.edges[1].kind = sim::CurveKind::Arc;
    panel.edges[1].arc_radius = 0.5;
    sim::Pattern pattern = of(panel);
    remove_vertices(pattern, 0, {1});
    const sim::Panel& joined = pattern.panels[0];
    EXPECT_EQ(joined.edges[0].kind, sim::CurveKind::Cubic);
    EXPECT_NEAR(sim::cross2(joined.edges[0].control[0].normalized(), Vec2d(0.2, -0.2).normalized()), 0, 1e-9);
    EXPECT_LT(nearest_on_edge(joined, joined.edges[0], {0.5, -0.2}).distance, 0.02);
}

TEST(RemoveVertices, seams_go_where_the_other_side_has_a_corner) {
    sim::Pattern pattern = two_squares();
    const int vertex = split_edge(pattern, {0, 1}, 0.5);
    move_vertices(pattern, 1, {4}, {-0.1, 0});
    remove_vertices(pattern, 0, {vertex});
    EXPECT_TRUE(pattern.seams.empty());
    EXPECT_EQ(pattern.panels[0].edges.size(), 4U);
    EXPECT_EQ(pattern.panels[1].edges.size(), 5U);
}

TEST(RemoveVertices, the_first_vertex_too_and_notches_keep_their_place) {
    sim::Panel panel = make_polygon({{0, 0}, {1, 0}, {2, 0.2}, {2, 1}, {0, 1}});
    panel.notches = {{.edge = 0, .t = 0.5}, {.edge = 4, .t = 0.5}, {.edge = 2, .t = 0.25}};
    panel.pins = {0, 3};
    sim::Pattern pattern = of(panel);
    remove_vertices(pattern, 0, {0});
    const sim::Panel& left = pattern.panels[0];
    ASSERT_EQ(left.edges.size(), 4U);
    EXPECT_EQ(left.pins, std::vector<int>{2});
    ASSERT_EQ(left.notches.size(), 3U);
    EXPECT_EQ(left.notches[0].edge, left.notches[1].edge);
    EXPECT_NEAR(left.notches[0].t, 0.75, 1e-9);
    EXPECT_NEAR(left.notches[1].t, 0.25, 1e-9);
    EXPECT_TRUE(outline_point(left, left.edges[std::size_t(left.notches[2].edge)], 0.25).isApprox(Vec2d(2, 0.4)));
}

TEST(RemoveVertices, refuses_to_leave_no_panel) {
    sim::Pattern pattern = two_squares();
    const sim::Pattern before = pattern;
    EXPECT_THROW(remove_vertices(pattern, 0, {0, 1, 2}), GeometryError);
    EXPECT_THROW(remove_vertices(pattern, 0, {0, 2}), GeometryError);
    EXPECT_THROW(remove_vertices(pattern, 0, {4}), GeometryError);
    EXPECT_TRUE(pattern == before);
}

TEST(MoveVertices, curves_with_one_end_moved_ride_along) {
    sim::Pattern pattern = of(bottomed(sim::CurveKind::Arc));
    const double before = edge_length(pattern, {0, 0});
    move_vertices(pattern, 0, {1}, {1, 0});
    EXPECT_NEAR(edge_length(pattern, {0, 0}), 2 * before, 1e-9);
    pattern = of(bottomed(sim::CurveKind::Cubic));
    move_vertices(pattern, 0, {1}, {1, 0});
    EXPECT_TRUE(pattern.panels[0].edges[0].control[0].isApprox(Vec2d(0.2, -0.8)));
    pattern = of(bottomed(sim::CurveKind::Cubic));
    move_vertices(pattern, 0, {0, 1}, {0, -0.5});
    EXPECT_TRUE(pattern.panels[0].edges[0].control[0].isApprox(Vec2d(0.1, -0.9)));
}

TEST(MoveVertices, refuses_an_outline_that_would_cross_itself_and_says_where) {
    sim::Pattern pattern = two_squares();
    const sim::Pattern before = pattern;
    try {
        move_vertices(pattern, 0, {2}, {-2, -0.5});
        FAIL() << "moved";
    } catch (const GeometryError& error) {
        ASSERT_FALSE(error.places().empty());
        EXPECT_EQ(error.places()[0].panel, "left");
        EXPECT_GE(error.places()[0].edge, 0);
    }
    EXPECT_THROW(move_vertices(pattern, 0, {0, 1}, {0, 2}), GeometryError);  // inside out
    EXPECT_THROW(move_vertices(pattern, 0, {0}, {1e300, 0}), GeometryError);
    EXPECT_THROW(move_vertices(pattern, 0, {1, 2}, {0, std::numeric_limits<double>::infinity()}), GeometryError);
    EXPECT_TRUE(pattern == before);
}

TEST(TransformPanel, a_turn_takes_lines_and_grain_along) {
    sim::Panel panel = bottomed(sim::CurveKind::Arc);
    panel.internal_lines = {{.name = "pleat", .points = {{0.5, 0.2}, {0.5, 0.8}}}};
    sim::Pattern pattern = of(panel);
    const double quarter = std::numbers::pi / 2;
    transform_panel(pattern, 0, Eigen::Affine2d(Eigen::Rotation2Dd(quarter)));
    EXPECT_NEAR(pattern.panels[0].grain_angle, quarter, 1e-12);
    EXPECT_TRUE(pattern.panels[0].internal_lines[0].points[0].isApprox(Vec2d(-0.2, 0.5)));
    EXPECT_NEAR(outline_area(pattern.panels[0]), outline_area(panel), 1e-12);
    EXPECT_EQ(pattern.panels[0].edges[0].kind, sim::CurveKind::Arc);
}

TEST(TransformPanel, a_mirroring_keeps_it_counter_clockwise_and_its_seams_together) {
    sim::Pattern pattern = two_squares();
    pattern.panels[0].notches = {{.edge = 1, .t = 0.25}};
    pattern.panels[0].edges[1].label = "side";
    transform_panel(pattern, 0, Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0)));
    const sim::Panel& panel = pattern.panels[0];
    EXPECT_GT(outline_area(panel), 0.9);
    EXPECT_EQ(pattern.seams[0].first, (sim::SeamSide{0, 3}));  // edge e of 4 becomes edge (4 - e) % 4
    EXPECT_FALSE(pattern.seams[0].is_reversed);
    EXPECT_EQ(panel.edges[3].label, "side");
    EXPECT_EQ(panel.notches[0], (sim::Notch{.edge = 3, .t = 0.75}));
    EXPECT_TRUE(outline_point(panel, panel.edges[3], 0.75).isApprox(Vec2d(-1, 0.25)));
    EXPECT_TRUE(panel.vertices[1].isApprox(Vec2d(-1, 0)));
    transform_panel(pattern, 0, Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0)));
    sim::Pattern whole = two_squares();
    whole.panels[0].notches = {{.edge = 1, .t = 0.25}};
    whole.panels[0].edges[1].label = "side";
    EXPECT_TRUE(pattern == whole);
}

TEST(TransformPanel, an_arc_becomes_a_cubic_under_a_stretch) {
    sim::Panel panel = bottomed(sim::CurveKind::Arc);
    sim::Pattern pattern = of(panel);
    transform_panel(pattern, 0, Eigen::Affine2d(Eigen::Scaling(1.5, 1.0)));
    EXPECT_EQ(pattern.panels[0].edges[0].kind, sim::CurveKind::Cubic);
    const Vec2d low = outline_point(panel, panel.edges[0], 0.5);
    EXPECT_NEAR((edge_point(pattern, {0, 0}, 0.5) - Vec2d(1.5 * low.x(), low.y())).norm(), 0, 1e-6);
    EXPECT_NEAR(outline_area(pattern.panels[0]), 1.5 * outline_area(panel), 2e-3);
}

TEST(TransformPanel, refuses_a_seam_side_four_times_too_long) {
    sim::Pattern pattern = two_squares();
    const sim::Pattern before = pattern;
    EXPECT_THROW(transform_panel(pattern, 0, Eigen::Affine2d(Eigen::Scaling(5.0, 5.0))), GeometryError);
    EXPECT_THROW(transform_panel(pattern, 0, Eigen::Affine2d(Eigen::Scaling(0.0, 1.0))), GeometryError);
    EXPECT_TRUE(pattern == before);
}

TEST(SetCurve, keeps_ends_and_label) {
    sim::Pattern pattern = two_squares();
    pattern.panels[0].edges[2].label = "top";
    set_curve(pattern, {0, 2}, {.start = 9, .end = 7, .kind = sim::CurveKind::Arc, .arc_radius = 0.7});
    const sim::OutlineEdge& edge = pattern.panels[0].edges[2];
    EXPECT_EQ(edge.start, 2);
    EXPECT_EQ(edge.end, 3);
    EXPECT_EQ(edge.label, "top");
    EXPECT_GT(edge_point(pattern, {0, 2}, 0.5).y(), 1.1);
    const sim::Pattern before = pattern;
    EXPECT_THROW(set_curve(pattern, {0, 2}, {.kind = sim::CurveKind::Arc, .arc_radius = 0.4}), GeometryError);
    EXPECT_THROW(
        set_curve(pattern, {0, 0}, {.kind = sim::CurveKind::Quadratic, .control = {Vec2d(0.5, 3), Vec2d(0, 0)}}),
        GeometryError);
    EXPECT_TRUE(pattern == before);
}

TEST(NearestOnEdge, is_found_on_every_kind_of_curve) {
    for (const sim::CurveKind kind :
         {sim::CurveKind::Line, sim::CurveKind::Quadratic, sim::CurveKind::Cubic, sim::CurveKind::Arc}) {
        const sim::Panel panel = bottomed(kind);
        for (const double t : {0.0, 0.1, 0.5, 0.77, 1.0}) {
            const Vec2d point = outline_point(panel, panel.edges[0], t);
            const sim::NearestOnEdge on = nearest_on_edge(panel, panel.edges[0], point);
            EXPECT_NEAR(on.t, t, 1e-6);
            EXPECT_NEAR(on.distance, 0, 1e-7);
        }
    }
    const sim::Panel square = unit_square();
    EXPECT_NEAR(nearest_on_edge(square, square.edges[0], {0.3, 0.4}).distance, 0.4, 1e-12);
    EXPECT_EQ(nearest_on_edge(square, square.edges[0], {-3, 4}).t, 0);
}

TEST(FindPanel, by_name) {
    const sim::Pattern pattern = two_squares();
    EXPECT_EQ(find_panel(pattern, "right"), 1);
    EXPECT_THROW(find_panel(pattern, "wrong"), GeometryError);
}

}  // namespace

}  // namespace selvedge::editor
