#include <gtest/gtest.h>
#include <algorithm>
#include <numbers>

#include "editor/geometry/outline_edit.h"
#include "editor/geometry/panel_edit.h"
#include "tests/editor/geometry/geometry_support.h"

namespace selvedge::editor {
namespace {

TEST(PanelNames, are_free) {
    sim::Pattern pattern = two_squares();
    EXPECT_EQ(free_panel_name(pattern, "front"), "front");
    EXPECT_EQ(free_panel_name(pattern, "left"), "left_2");
    EXPECT_EQ(free_panel_name(pattern, ""), "panel");
    EXPECT_EQ(add_panel(pattern, unit_square("left")), 2);
    EXPECT_EQ(pattern.panels[2].name, "left_2");
    EXPECT_EQ(free_panel_name(pattern, "left_2"), "left_3");
}

TEST(PanelNames, change_and_mirror_images_follow) {
    sim::Pattern pattern = two_squares();
    pattern.panels[1].mirror_of = "left";
    rename_panel(pattern, 0, "vest");
    EXPECT_EQ(pattern.panels[0].name, "vest");
    EXPECT_EQ(pattern.panels[1].mirror_of, "vest");
    const sim::Pattern before = pattern;
    EXPECT_THROW(rename_panel(pattern, 0, "right"), GeometryError);
    EXPECT_THROW(rename_panel(pattern, 0, ""), GeometryError);
    EXPECT_THROW(rename_panel(pattern, 5, "x"), GeometryError);
    EXPECT_TRUE(pattern == before);
}

TEST(MakePanel, turns_any_polygon_counter_clockwise) {
    EXPECT_GT(outline_area(make_polygon({{0, 0}, {0, 1}, {1, 0}})), 0.49);
    EXPECT_NEAR(outline_area(make_rectangle({0.5, 0.2}, {-0.5, 0})), 0.2, 1e-12);
    EXPECT_THROW(make_polygon({{0, 0}, {0, 1}}), GeometryError);
    EXPECT_THROW(make_polygon({}), GeometryError);
    EXPECT_THROW(make_polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), GeometryError);
    EXPECT_THROW(make_rectangle({0, 0}, {0, 1}), GeometryError);
}

TEST(MakePanel, an_ellipse_is_round) {
    const sim::Panel ellipse = make_ellipse({1, 2}, {0.3, 0.2});
    EXPECT_NEAR(outline_area(ellipse), std::numbers::pi * 0.06, 2e-4);
    for (const sim::OutlineEdge& edge : ellipse.edges) {
        const Vec2d p = (outline_point(ellipse, edge, 0.37) - Vec2d(1, 2)).cwiseQuotient(Vec2d(0.3, 0.2));
        EXPECT_NEAR(p.norm(), 1, 5e-4);
    }
    EXPECT_THROW(make_ellipse({0, 0}, {0, 1}), GeometryError);
}

TEST(AddPanel, refuses_what_is_no_panel) {
    sim::Pattern pattern = two_squares();
    const sim::Pattern before = pattern;
    EXPECT_THROW(add_panel(pattern, sim::Panel()), GeometryError);
    sim::Panel open = unit_square();
    open.edges[1].end = 3;
    EXPECT_THROW(add_panel(pattern, open), GeometryError);
    sim::Panel pinned = unit_square();
    pinned.pins = {4};
    EXPECT_THROW(add_panel(pattern, pinned), GeometryError);
    EXPECT_TRUE(pattern == before);
}

TEST(RemovePanels, takes_their_seams_and_frees_their_images) {
    sim::Pattern pattern = two_squares();
    add_panel(pattern, unit_square("third"));
    pattern.panels[2].mirror_of = "left";
    pattern.seams.push_back({{1, 0}, {2, 0}});
    remove_panels(pattern, {0, 0});
    ASSERT_EQ(pattern.panels.size(), 2U);
    ASSERT_EQ(pattern.seams.size(), 1U);
    EXPECT_EQ(pattern.seams[0].first, (sim::SeamSide{0, 0}));
    EXPECT_EQ(pattern.seams[0].second, (sim::SeamSide{1, 0}));
    EXPECT_EQ(pattern.panels[1].mirror_of, "");
}

TEST(DuplicatePanels, one_lies_beside_it_unsewn) {
    sim::Pattern pattern = two_squares();
    const Vec2d at = sheet_positions(pattern)[1];
    EXPECT_EQ(duplicate_panels(pattern, {1}, {.on_sheet = {0, -2}, .in_world = {1, 0, 0}}), std::vector<int>{2});
    EXPECT_EQ(pattern.panels[2].name, "right_2");
    EXPECT_TRUE(pattern.panels[2].sheet_position.value().isApprox(at + Vec2d(0, -2)));
    EXPECT_EQ(pattern.seams.size(), 1U);
    EXPECT_EQ(pattern.panels[2].vertices, pattern.panels[1].vertices);
    EXPECT_TRUE(pattern.panels[2].translation.isApprox(pattern.panels[1].translation + Vec3d(1, 0, 0)));
}

TEST(FreeShift, leads_past_the_panels_in_the_way) {
    sim::Pattern pattern = two_squares();
    pattern.panels[0].sheet_position = Vec2d(0, 0);
    pattern.panels[1].sheet_position = Vec2d(1.2, 0.5);
    std::vector<sim::Panel> copies{pattern.panels[0]};
    EXPECT_TRUE(free_shift(pattern, copies).isApprox(Vec2d(2.25, 0))) << "the gap of 20 cm is too narrow";
    copies[0].sheet_position = Vec2d(0, -1.1);
    EXPECT_TRUE(free_shift(pattern, copies).isZero());
}

TEST(DuplicatePanels, keep_their_darts_and_the_seams_among_them) {
    sim::Pattern pattern = two_squares();
    add_panel(pattern, unit_square("third"));
    pattern.seams.push_back(
        {.first = {1, 1}, .second = {2, 3}, .is_reversed = false, .name = "to_third", .is_eased = true});
    insert_dart(pattern, {0, 0}, 0.3, 0.1, 0.4);
    const sim::Seam dart = pattern.seams.back();
    ASSERT_EQ(pattern.seams.size(), 3U);
    const sim::Pattern before = pattern;
    EXPECT_EQ(duplicate_panels(pattern, {1, 0}, {.on_sheet = {0, -2}}), (std::vector<int>{3, 4}));
    ASSERT_EQ(pattern.seams.size(), 5U);
    EXPECT_TRUE(std::equal(before.seams.begin(), before.seams.end(), pattern.seams.begin()));
    const sim::Seam& middle = before.seams[0];  // the dart has changed its edge
    EXPECT_EQ(pattern.seams[3], (sim::Seam{{4, middle.first.edge}, {3, middle.second.edge}}));
    EXPECT_EQ(
        pattern.seams[4],
        (sim::Seam{.first = {4, dart.first.edge}, .second = {4, dart.second.edge}, .is_reversed = dart.is_reversed}));
    EXPECT_TRUE(can_be_saved(pattern));
}

TEST(AddPanels, refuses_seams_of_panels_that_are_not_added) {
    sim::Pattern pattern = two_squares();
    const sim::Pattern before = pattern;
    EXPECT_THROW(add_panels(pattern, {unit_square()}, {{{0, 0}, {1, 0}, true}}), GeometryError);
    EXPECT_THROW(add_panels(pattern, {unit_square()}, {{{0, 0}, {-1, 0}, true}}), GeometryError);
    EXPECT_THROW(add_panels(pattern, {unit_square()}, {{{0, 0}, {0, 4}, true}}), GeometryError);
    EXPECT_TRUE(pattern == before);
}

// An L shape; edges: bottom, right, step, inner, top, left.
sim::Panel ell() {
    sim::Panel panel = make_polygon({{0, 0}, {1, 0}, {1, 0.5}, {0.5, 0.5}, {0.5, 1}, {0, 1}});
    panel.name = "ell";
    return panel;
}

TEST(CutPanel, both_parts_stay_where_they_were_and_keep_what_was_theirs) {
    sim::Pattern pattern = two_squares();
    sim::Panel& panel = pattern.panels[0];
    panel.wrap_radius = 0.4;
    panel.translation = {0.1, 1, 0.2};
    panel.grain_angle = 0.3;
    panel.notches = {{.edge = 0, .t = 0.25}, {.edge = 0, .t = 0.75}, {.edge = 1, .t = 0.5}, {.edge = 3, .t = 0.5}};
    panel.pins = {0, 1};
    panel.internal_lines = {{.name = "pleat", .points = {{0.1, 0.5}, {0.9, 0.5}}},
                            {.name = "dart", .points = {{0.8, 0.1}, {0.9, 0.1}}}};
    const sim::Panel before = panel;
    const Vec2d sheet = sheet_positions(pattern)[0];
    // From the bottom to the top, with a bend to the left. The part on the right of the path is the new panel.
    EXPECT_EQ(cut_panel(pattern, 0, {{0.5, -0.01}, {0.4, 0.5}, {0.5, 1.01}}, true), 2);
    const sim::Panel& kept = pattern.panels[0];
    const sim::Panel& taken = pattern.panels[2];
    EXPECT_EQ(taken.name, "left_2");
    EXPECT_NEAR(outline_area(kept), 0.45, 1e-9);
    EXPECT_NEAR(outline_area(taken), 0.55, 1e-9);
    EXPECT_TRUE(taken.place({0.7, 0.3}).isApprox(before.place({0.7, 0.3})));
    EXPECT_TRUE(kept.place({0.7, 0.3}).isApprox(before.place({0.7, 0.3})));
    EXPECT_EQ(taken.grain_angle, before.grain_angle);
    EXPECT_TRUE(kept.sheet_position.value().isApprox(sheet));
    EXPECT_NEAR((taken.sheet_position.value() - sheet).norm(), 0.02, 1e-12);
    EXPECT_GT(taken.sheet_position.value().x(), sheet.x());
    EXPECT_EQ(kept.notches.size(), 2U);
    EXPECT_EQ(taken.notches.size(), 2U);
    for (const sim::Notch& notch : taken.notches) {
        EXPECT_GT(outline_point(taken, taken.edges[std::size_t(notch.edge)], notch.t).x(), 0.7);
    }
    ASSERT_EQ(kept.pins.size(), 1U);
    EXPECT_TRUE(kept.vertices[std::size_t(kept.pins[0])].isApprox(Vec2d(0, 0)));
    ASSERT_EQ(taken.pins.size(), 1U);
    EXPECT_TRUE(taken.vertices[std::size_t(taken.pins[0])].isApprox(Vec2d(1, 0)));
    ASSERT_EQ(kept.internal_lines.size(), 1U);
    EXPECT_TRUE(kept.internal_lines[0].points.back().isApprox(Vec2d(0.4, 0.5)));
    EXPECT_EQ(taken.internal_lines.size(), 2U);
    ASSERT_EQ(pattern.seams.size(), 3U);
    EXPECT_EQ(pattern.seams[0].name, "middle");
    EXPECT_EQ(pattern.seams[0].first.panel, 2);
    EXPECT_TRUE(edge_point(pattern, pattern.seams[0].first, 0.3).isApprox(Vec2d(1, 0.3)));
    for (std::size_t i = 1; i < 3; ++i) {
        const sim::Seam& seam = pattern.seams[i];
        EXPECT_EQ(seam.first.panel, 0);
        EXPECT_EQ(seam.second.panel, 2);
        for (const double t : {0.0, 0.4, 1.0}) {
            EXPECT_TRUE(edge_point(pattern, seam.first, t).isApprox(edge_point(pattern, seam.second, 1 - t)));
        }
    }
    EXPECT_TRUE(can_be_saved(pattern));
}

TEST(CutPanel, from_either_end_and_across_edge_0) {
    for (const bool is_downward : {true, false}) {
        sim::Pattern pattern;
        pattern.panels = {ell()};
        std::vector<Vec2d> path{{0.25, 1}, {0.25, 0}};
        if (!is_downward) std::swap(path[0], path[1]);
        cut_panel(pattern, 0, path, false);
        EXPECT_NEAR(outline_area(pattern.panels[0]), is_downward ? 0.5 : 0.25, 1e-12);
        EXPECT_NEAR(outline_area(pattern.panels[1]), is_downward ? 0.25 : 0.5, 1e-12);
        EXPECT_TRUE(pattern.seams.empty());
        EXPECT_TRUE(can_be_saved(pattern));
    }
}

TEST(CutPanel, at_vertices_and_through_a_seam_that_is_split) {
    sim::Pattern pattern = two_squares();
    cut_panel(pattern, 0, {{0, 0}, {1, 1}}, true);
    EXPECT_EQ(pattern.panels[0].edges.size(), 3U);
    EXPECT_EQ(pattern.panels[2].edges.size(), 3U);
    pattern = two_squares();
    cut_panel(pattern, 0, {{1.02, 0.3}, {-0.02, 0.3}}, true);
    EXPECT_EQ(pattern.panels[1].edges.size(), 5U);
    ASSERT_EQ(pattern.seams.size(), 3U);
    for (const sim::Seam& seam : pattern.seams) {
        EXPECT_NEAR(edge_length(pattern, seam.first), edge_length(pattern, seam.second), 1e-12);
    }
}

TEST(CutPanel, refuses_a_path_that_leaves_the_panel) {
    sim::Pattern pattern;
    pattern.panels = {ell()};
    const sim::Pattern before = pattern;
    EXPECT_THROW(cut_panel(pattern, 0, {{0.75, 0.5}, {0.5, 0.75}}, true), GeometryError);  // outside, both directions
    EXPECT_THROW(cut_panel(pattern, 0, {{0.5, 0.75}, {0.75, 0.5}}, true), GeometryError);
    EXPECT_THROW(cut_panel(pattern, 0, {{0, 0.75}, {1, 0.25}}, true), GeometryError);  // crosses the corner
    EXPECT_THROW(cut_panel(pattern, 0, {{0.2, 0}, {0.2, 0.5}, {0.8, 0.2}, {0.1, 0.2}, {0, 0.5}}, true), GeometryError);
    EXPECT_THROW(cut_panel(pattern, 0, {{0.2, 0}, {0.2, 0}}, true), GeometryError);
    EXPECT_THROW(cut_panel(pattern, 0, {{0.2, 0}, {0.8, 0}}, true), GeometryError);
    EXPECT_THROW(cut_panel(pattern, 0, {{0.2, 0}}, true), GeometryError);
    EXPECT_THROW(cut_panel(pattern, 1, {{0.2, 0}, {0.2, 1}}, true), GeometryError);
    EXPECT_TRUE(pattern == before);
}

TEST(MergePanels, takes_back_a_cut) {
    sim::Pattern pattern = two_squares();
    pattern.panels[0].notches = {{.edge = 1, .t = 0.5}, {.edge = 3, .t = 0.5}};
    cut_panel(pattern, 0, {{0.6, 0}, {0.5, 0.5}, {0.6, 1}}, true);
    EXPECT_EQ(merge_panels(pattern, 1).panel, 0);
    ASSERT_EQ(pattern.panels.size(), 2U);
    EXPECT_NEAR(outline_area(pattern.panels[0]), 1, 1e-12);
    EXPECT_EQ(pattern.panels[0].edges.size(), 6U);
    EXPECT_EQ(pattern.panels[0].vertices.size(), 6U);
    EXPECT_EQ(pattern.panels[0].notches.size(), 2U);
    ASSERT_EQ(pattern.seams.size(), 1U);
    EXPECT_EQ(pattern.seams[0].name, "middle");
    EXPECT_TRUE(edge_point(pattern, pattern.seams[0].first, 0.3).isApprox(Vec2d(1, 0.3)));
    EXPECT_TRUE(can_be_saved(pattern));
}

TEST(MergePanels, turns_and_moves_the_second_of_two_equal_ones_to_the_first) {
    sim::Pattern pattern = two_squares();
    transform_panel(pattern, 0, Eigen::Affine2d(Eigen::Translation2d(3, 1) * Eigen::Rotation2Dd(0.7)));
    pattern.panels[1].pins = {1, 3};
    EXPECT_EQ(merge_panels(pattern, 0).panel, 0);
    EXPECT_NEAR(outline_area(pattern.panels[0]), 2, 1e-9);
    EXPECT_EQ(pattern.panels[0].edges.size(), 6U);
    EXPECT_EQ(pattern.panels[0].pins.size(), 2U);
    EXPECT_TRUE(pattern.seams.empty());
}

// A small piece, turned by 40 degrees with its grain, and a large one, which is sewn to it as the second side.
sim::Pattern small_and_large() {
    sim::Pattern pattern = two_squares();
    pattern.panels[0] = make_rectangle({0, 0}, {0.2, 1});
    pattern.panels[0].name = "band";
    pattern.panels[0].notches = {{.edge = 0, .t = 0.25}};
    pattern.panels[0].internal_lines = {{.name = "fold", .points = {{0.1, 0.2}, {0.1, 0.8}}}};
    transform_panel(pattern, 0, Eigen::Affine2d(Eigen::Translation2d(3, 1) * Eigen::Rotation2Dd(0.7)));
    pattern.panels[1].grain_angle = 0.1;
    pattern.panels[1].sett_offset = {0.02, 0.03};
    pattern.panels[1].sheet_position = Vec2d(5, 6);
    return pattern;
}

TEST(MergePanels, leaves_the_larger_one_where_it_lies_with_its_grain_sett_and_placement) {
    sim::Pattern pattern = small_and_large();
    const sim::Panel large = pattern.panels[1];
    const Merged merged = merge_panels(pattern, 0);
    ASSERT_EQ(pattern.panels.size(), 1U);
    const sim::Panel& joined = pattern.panels[static_cast<std::size_t>(merged.panel)];
    EXPECT_EQ(joined.name, "right");
    EXPECT_EQ(joined.translation, large.translation);
    EXPECT_EQ(joined.grain_angle, 0.1);
    EXPECT_EQ(joined.sett_offset, large.sett_offset);
    EXPECT_EQ(joined.sheet_position, large.sheet_position);
    for (const Vec2d& corner : large.vertices) {
        const auto is_there = [&](const Vec2d& vertex) { return (vertex - corner).norm() < 1e-12; };
        EXPECT_TRUE(std::ranges::any_of(joined.vertices, is_there)) << corner.transpose();
    }
    ASSERT_EQ(joined.notches.size(), 1U);
    const sim::Notch& notch = joined.notches[0];
    EXPECT_TRUE(outline_point(joined, joined.edges[std::size_t(notch.edge)], notch.t).isApprox(Vec2d(-0.15, 0), 1e-9));
    ASSERT_EQ(joined.internal_lines.size(), 1U);
    EXPECT_TRUE(joined.internal_lines[0].points[1].isApprox(Vec2d(-0.1, 0.8), 1e-9));
}

TEST(MergePanels, tells_of_a_grain_that_the_moved_one_had_otherwise) {
    sim::Pattern pattern = small_and_large();
    const Merged merged = merge_panels(pattern, 0);
    ASSERT_EQ(merged.notes.size(), 1U);
    EXPECT_NE(merged.notes[0].find("its grain ran 5.7 degrees off"), std::string::npos) << merged.notes[0];
    pattern = small_and_large();
    pattern.panels[1].grain_angle = 0;
    EXPECT_TRUE(merge_panels(pattern, 0).notes.empty()) << "it is turned with its grain";
}

TEST(MergePanels, leaves_the_named_one_where_it_lies) {
    sim::Pattern pattern = small_and_large();
    const sim::Panel small = pattern.panels[0];
    EXPECT_EQ(merge_panels(pattern, 0, 0).panel, 0);
    EXPECT_EQ(pattern.panels[0].name, "band");
    EXPECT_EQ(pattern.panels[0].grain_angle, small.grain_angle);
    EXPECT_NEAR(outline_area(pattern.panels[0]), 1.2, 1e-9);
    pattern = small_and_large();
    pattern.panels.push_back(unit_square("other"));
    EXPECT_THROW(merge_panels(pattern, 0, 2), GeometryError);
}

TEST(MergePanels, refuses_sides_that_do_not_fit) {
    sim::Pattern pattern = two_squares();
    set_curve(pattern, {1, 3}, {.kind = sim::CurveKind::Quadratic, .control = {Vec2d(-0.1, 0.5), Vec2d(0, 0)}});
    sim::Pattern before = pattern;
    EXPECT_THROW(merge_panels(pattern, 0), GeometryError);
    EXPECT_TRUE(pattern == before);
    pattern = two_squares();
    pattern.seams[0].is_reversed = false;
    EXPECT_THROW(merge_panels(pattern, 0), GeometryError);
    pattern.seams = {{{0, 0}, {0, 1}}};
    EXPECT_THROW(merge_panels(pattern, 0), GeometryError);
    EXPECT_THROW(merge_panels(pattern, 1), GeometryError);
}

TEST(UnfoldPanel, opens_what_was_cut_on_the_fold) {
    sim::Pattern pattern = two_squares();
    pattern.panels[0].notches = {{.edge = 0, .t = 0.25}, {.edge = 3, .t = 0.5}};
    pattern.panels[0].pins = {1, 3};
    pattern.panels[0].internal_lines = {{.name = "pocket", .points = {{0.5, 0.5}, {0.8, 0.5}}}};
    unfold_panel(pattern, {0, 3});
    const sim::Panel& panel = pattern.panels[0];
    EXPECT_NEAR(outline_area(panel), 2, 1e-12);
    EXPECT_EQ(panel.edges.size(), 6U);
    ASSERT_EQ(pattern.seams.size(), 1U);
    EXPECT_EQ(pattern.seams[0].first, (sim::SeamSide{0, 1}));
    EXPECT_TRUE(edge_point(pattern, {0, 1}, 0.3).isApprox(Vec2d(1, 0.3)));
    ASSERT_EQ(panel.notches.size(), 2U);
    EXPECT_TRUE(outline_point(panel, panel.edges[std::size_t(panel.notches[1].edge)], panel.notches[1].t)
                    .isApprox(Vec2d(-0.25, 0)));
    ASSERT_EQ(panel.pins.size(), 3U);
    EXPECT_TRUE(panel.vertices[std::size_t(panel.pins[2])].isApprox(Vec2d(-1, 0)));
    EXPECT_TRUE(panel.internal_lines[1].points[1].isApprox(Vec2d(-0.8, 0.5)));
    EXPECT_TRUE(can_be_saved(pattern));
}

TEST(UnfoldPanel, darts_are_there_twice_and_a_seam_at_the_fold_goes) {
    sim::Pattern pattern = two_squares();
    insert_dart(pattern, {0, 0}, 0.5, 0.1, 0.4);
    unfold_panel(pattern, {0, 4});  // the right side: the dart added three edges before it
    EXPECT_NEAR(outline_area(pattern.panels[0]), 2 * (1 - 0.02), 1e-9);
    ASSERT_EQ(pattern.seams.size(), 2U);
    for (const sim::Seam& seam : pattern.seams) {
        EXPECT_EQ(seam.second.panel, 0);
        EXPECT_NEAR(edge_length(pattern, seam.first), edge_length(pattern, seam.second), 1e-12);
        const double apex = std::min((edge_point(pattern, seam.first, 1) - edge_point(pattern, seam.second, 0)).norm(),
                                     (edge_point(pattern, seam.first, 0) - edge_point(pattern, seam.second, 1)).norm());
        EXPECT_NEAR(apex, 0, 1e-12);
    }
    EXPECT_TRUE(can_be_saved(pattern));
}

TEST(UnfoldPanel, refuses_a_curved_fold_and_one_that_the_panel_crosses) {
    sim::Pattern pattern;
    pattern.panels = {ell()};
    set_curve(pattern, {0, 5}, {.kind = sim::CurveKind::Quadratic, .control = {Vec2d(-0.1, 0.5), Vec2d(0, 0)}});
    const sim::Pattern before = pattern;
    EXPECT_THROW(unfold_panel(pattern, {0, 5}), GeometryError);
    EXPECT_THROW(unfold_panel(pattern, {0, 2}), GeometryError);
    EXPECT_THROW(unfold_panel(pattern, {0, 9}), GeometryError);
    EXPECT_TRUE(pattern == before);
}

TEST(InsertDart, cuts_a_wedge_inward_with_legs_of_one_length) {
    sim::Pattern pattern = two_squares();
    set_curve(pattern, {0, 2}, {.kind = sim::CurveKind::Arc, .arc_radius = 0.8});
    const double area = outline_area(pattern.panels[0]);
    insert_dart(pattern, {0, 2}, 0.3, 0.1, 0.4);
    const sim::Seam& legs = pattern.seams.back();
    EXPECT_TRUE(legs.is_reversed);
    EXPECT_NEAR(edge_length(pattern, legs.first), edge_length(pattern, legs.second), 1e-12);
    const Vec2d mouth = edge_point(pattern, legs.first, 0) - edge_point(pattern, legs.second, 1);
    EXPECT_NEAR(mouth.norm(), 0.1, 1e-4);
    const Vec2d apex = edge_point(pattern, legs.first, 1);
    EXPECT_NEAR((apex - (edge_point(pattern, legs.first, 0) + edge_point(pattern, legs.second, 1)) / 2).norm(), 0.4,
                1e-12);
    EXPECT_LT(apex.y(), 0.9);
    EXPECT_NEAR(outline_area(pattern.panels[0]), area - 0.02, 2e-4);
    EXPECT_EQ(pattern.panels[0].edges.size(), 7U);
    EXPECT_TRUE(can_be_saved(pattern));
}

TEST(InsertDart, what_is_left_of_a_sewn_edge_stays_sewn_to_the_whole_other_side) {
    for (const bool is_reversed : {true, false}) {
        sim::Pattern pattern = two_squares();
        pattern.seams[0].is_reversed = is_reversed;
        insert_dart(pattern, {0, 1}, 0.3, 0.2, 0.4);
        ASSERT_EQ(pattern.seams.size(), 3U);
        EXPECT_EQ(pattern.seams[0].name, "middle");
        EXPECT_NEAR(edge_length(pattern, pattern.seams[0].first), 0.2, 1e-12);
        EXPECT_NEAR(edge_length(pattern, pattern.seams[0].second), 0.25, 1e-12);
        EXPECT_NEAR(edge_length(pattern, pattern.seams[1].first), 0.6, 1e-12);
        EXPECT_NEAR(edge_length(pattern, pattern.seams[1].second), 0.75, 1e-12);
        const double from = is_reversed ? 1 : 0;
        EXPECT_EQ(edge_point(pattern, pattern.seams[0].second, from).y(), is_reversed ? 0 : 1);
        EXPECT_EQ(edge_point(pattern, pattern.seams[1].second, 1 - from).y(), is_reversed ? 1 : 0);
    }
}

TEST(InsertDart, refuses_one_that_does_not_fit) {
    sim::Pattern pattern = two_squares();
    const sim::Pattern before = pattern;
    EXPECT_THROW(insert_dart(pattern, {0, 0}, 0.05, 0.2, 0.3), GeometryError);
    EXPECT_THROW(insert_dart(pattern, {0, 0}, 0.5, 0.2, 1.3), GeometryError);
    EXPECT_THROW(insert_dart(pattern, {0, 0}, 0.5, 0, 0.3), GeometryError);
    EXPECT_THROW(insert_dart(pattern, {0, 0}, 0.5, 0.1, -0.3), GeometryError);
    EXPECT_TRUE(pattern == before);
}

}  // namespace

}  // namespace selvedge::editor
