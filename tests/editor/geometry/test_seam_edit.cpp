#include <gtest/gtest.h>

#include "editor/geometry/outline_edit.h"
#include "editor/geometry/panel_edit.h"
#include "editor/geometry/seam_edit.h"
#include "tests/editor/geometry/geometry_support.h"

namespace selvedge::editor {
namespace {

sim::Pattern unsewn_squares() {
    sim::Pattern pattern = two_squares();
    pattern.seams.clear();
    return pattern;
}

TEST(SewEdges, adds_a_seam_once) {
    sim::Pattern pattern = unsewn_squares();
    EXPECT_EQ(sew_edges(pattern, {{0, 1}, {1, 3}, true}), 0);
    EXPECT_EQ(sew_edges(pattern, {{0, 0}, {0, 2}, false}), 1);
    const sim::Pattern before = pattern;
    EXPECT_THROW(sew_edges(pattern, {{0, 1}, {1, 0}, true}), GeometryError);
    EXPECT_THROW(sew_edges(pattern, {{1, 0}, {1, 3}, true}), GeometryError);
    EXPECT_THROW(sew_edges(pattern, {{1, 0}, {1, 0}, true}), GeometryError);
    EXPECT_THROW(sew_edges(pattern, {{1, 0}, {2, 0}, true}), GeometryError);
    EXPECT_TRUE(pattern == before);
}

TEST(SewEdges, refuses_a_side_over_four_times_as_long) {
    sim::Pattern pattern = unsewn_squares();
    pattern.panels[1] = make_rectangle({0, 0}, {1, 0.24});
    EXPECT_THROW(sew_edges(pattern, {{0, 1}, {1, 3}, true}), GeometryError);
    pattern.panels[1] = make_rectangle({0, 0}, {1, 0.26});
    EXPECT_EQ(sew_edges(pattern, {{0, 1}, {1, 3}, true}), 0);
    EXPECT_DOUBLE_EQ(seam_lengths(pattern, pattern.seams[0])[0], 1);
    EXPECT_DOUBLE_EQ(seam_lengths(pattern, pattern.seams[0])[1], 0.26);
}

// Expects each seam's first side to be `ratio` times as long as its second.
void expect_even_seams(const sim::Pattern& pattern, const std::vector<int>& seams, double ratio) {
    for (const int index : seams) {
        const auto [first, second] = seam_lengths(pattern, pattern.seams[static_cast<std::size_t>(index)]);
        EXPECT_NEAR(first / second, ratio, 1e-9);
    }
}

TEST(SewRuns, one_edge_to_three_by_share_of_length) {
    for (const bool is_reversed : {true, false}) {
        sim::Pattern pattern = unsewn_squares();
        split_edge(pattern, {1, 3}, 0.2);
        split_edge(pattern, {1, 4}, 0.5);  // lengths 0.2, 0.4, 0.4 from the top of the left side down
        const std::vector<int> seams = sew_runs(pattern, {{0, 1}}, {{1, 3}, {1, 4}, {1, 5}}, is_reversed);
        ASSERT_EQ(seams, (std::vector<int>{0, 1, 2}));
        expect_even_seams(pattern, seams, 1);
        EXPECT_EQ(pattern.panels[0].edges.size(), 6U);
        EXPECT_EQ(pattern.seams[0].first, (sim::SeamSide{0, 1}));
        EXPECT_EQ(pattern.seams[0].second, (sim::SeamSide{1, is_reversed ? 5 : 3}));
        EXPECT_EQ(pattern.seams[2].second, (sim::SeamSide{1, is_reversed ? 3 : 5}));
        EXPECT_EQ(pattern.seams[0].is_reversed, is_reversed);
        EXPECT_NEAR(edge_length(pattern, {0, 1}), is_reversed ? 0.4 : 0.2, 1e-9);
    }
}

TEST(SewRuns, parts_of_edges_are_split_off) {
    sim::Pattern pattern = unsewn_squares();
    const std::vector<int> seams = sew_runs(pattern, {{0, 1, 0.5, 1}, {0, 2, 0, 0.5}}, {{1, 3, 0.25, 0.75}}, true);
    ASSERT_EQ(seams.size(), 2U);
    expect_even_seams(pattern, seams, 2);
    EXPECT_EQ(pattern.panels[0].edges.size(), 6U);
    EXPECT_EQ(pattern.panels[1].edges.size(), 7U);
    EXPECT_TRUE(edge_point(pattern, pattern.seams[0].first, 0).isApprox(Vec2d(1, 0.5)));
    EXPECT_TRUE(edge_point(pattern, pattern.seams[0].second, 1).isApprox(Vec2d(0, 0.25), 1e-9));
    EXPECT_TRUE(edge_point(pattern, pattern.seams[1].first, 1).isApprox(Vec2d(0.5, 1)));
    EXPECT_TRUE(edge_point(pattern, pattern.seams[1].second, 0).isApprox(Vec2d(0, 0.75), 1e-9));
    EXPECT_TRUE(can_be_saved(pattern));
}

TEST(SewRuns, two_parts_of_one_edge_and_none_twice) {
    sim::Pattern pattern = unsewn_squares();
    const sim::Pattern before = pattern;
    EXPECT_THROW(sew_runs(pattern, {{0, 1, 0, 0.6}}, {{0, 1, 0.4, 1}}, true), GeometryError);
    EXPECT_THROW(sew_runs(pattern, {{0, 1}}, {}, true), GeometryError);
    EXPECT_THROW(sew_runs(pattern, {{0, 1, 0.5, 0.5}}, {{1, 1}}, true), GeometryError);
    EXPECT_THROW(sew_runs(pattern, {{0, 1, -0.5, 0.5}}, {{1, 1, 0.2, 2}}, true), GeometryError);
    EXPECT_THROW(sew_runs(pattern, {{0, 7}}, {{1, 1}}, true), GeometryError);
    EXPECT_TRUE(pattern == before);
    ASSERT_EQ(sew_runs(pattern, {{0, 1, 0, 0.5}}, {{0, 1, 0.5, 1}}, true).size(), 1U);
    EXPECT_EQ(pattern.seams[0], (sim::Seam{{0, 1}, {0, 2}}));
    EXPECT_THROW(sew_runs(pattern, {{0, 2, 0, 0.5}}, {{1, 1}}, true), GeometryError);  // sewn already
}

TEST(RemoveSeams, in_any_order_and_twice) {
    sim::Pattern pattern = unsewn_squares();
    for (int e = 0; e < 4; ++e) sew_edges(pattern, {{0, e}, {1, e}, true});
    remove_seams(pattern, {2, 0, 2});
    ASSERT_EQ(pattern.seams.size(), 2U);
    EXPECT_EQ(pattern.seams[0].first.edge, 1);
    EXPECT_EQ(pattern.seams[1].first.edge, 3);
    EXPECT_THROW(remove_seams(pattern, {0, 2}), GeometryError);
    EXPECT_EQ(pattern.seams.size(), 2U);
}

TEST(EvenSeam, moves_the_end_that_is_free) {
    sim::Pattern pattern = unsewn_squares();
    pattern.panels[1] = make_rectangle({0, 0}, {1, 0.8});
    sew_edges(pattern, {{0, 1}, {1, 3}, true});
    sew_edges(pattern, {{0, 2}, {1, 2}, true});  // fixes the upper end
    equalize_seam(pattern, 0);
    EXPECT_NEAR(edge_length(pattern, {1, 3}), 1, 1e-12);
    EXPECT_NEAR(edge_length(pattern, {0, 1}), 1, 1e-12);
    EXPECT_TRUE(pattern.panels[1].vertices[3].isApprox(Vec2d(0, 0.8)));
    EXPECT_TRUE(pattern.panels[1].vertices[0].isApprox(Vec2d(0, -0.2)));
}

TEST(EvenSeam, scales_a_curve_with_its_chord_and_moves_both_ends_when_both_are_free) {
    sim::Pattern pattern = unsewn_squares();
    set_curve(pattern, {1, 3}, {.kind = sim::CurveKind::Quadratic, .control = {Vec2d(-0.5, 0.5), Vec2d(0, 0)}});
    sew_edges(pattern, {{0, 1}, {1, 3}, true});
    equalize_seam(pattern, 0);
    EXPECT_NEAR(edge_length(pattern, {1, 3}), 1, 1e-9);
    EXPECT_NEAR(pattern.panels[1].vertices[0].y() + pattern.panels[1].vertices[3].y(), 1, 1e-9);
}

TEST(EvenSeam, a_dart_keeps_its_apex) {
    sim::Pattern pattern = unsewn_squares();
    insert_dart(pattern, {0, 0}, 0.5, 0.1, 0.4);
    move_vertices(pattern, 0, {5}, {0.02, -0.05});
    const sim::Seam dart = pattern.seams[0];
    const sim::OutlineEdge leg = pattern.panels[0].edges[static_cast<std::size_t>(dart.second.edge)];
    const Vec2d apex = pattern.panels[0].vertices[static_cast<std::size_t>(leg.start)];
    equalize_seam(pattern, 0);
    const auto [first, second] = seam_lengths(pattern, pattern.seams[0]);
    EXPECT_NEAR(first, second, 1e-12);
    EXPECT_TRUE(pattern.panels[0].vertices[static_cast<std::size_t>(leg.start)].isApprox(apex, 1e-15));
}

TEST(IsCrossed, as_the_panels_lie_on_the_sheet) {
    sim::Pattern pattern = unsewn_squares();
    pattern.panels[1].translation = Vec3d::Zero();
    EXPECT_FALSE(is_crossed(pattern, {{0, 1}, {1, 3}, true}));
    EXPECT_TRUE(is_crossed(pattern, {{0, 1}, {1, 3}, false}));
}

TEST(IsCrossed, as_the_panels_stand_in_the_room) {
    for (const char* name : {"tshirt", "skirt"}) {
        const sim::Pattern pattern = shipped_pattern(name);
        for (sim::Seam seam : pattern.seams) {
            EXPECT_FALSE(is_crossed(pattern, seam));
            seam.is_reversed = !seam.is_reversed;
            EXPECT_TRUE(is_crossed(pattern, seam));
        }
    }
}

TEST(IsCrossed, legs_of_a_dart_meet_at_its_apex) {
    sim::Pattern pattern = unsewn_squares();
    insert_dart(pattern, {0, 0}, 0.5, 0.1, 0.4);
    sim::Seam dart = pattern.seams[0];
    EXPECT_FALSE(is_crossed(pattern, dart));
    dart.is_reversed = false;
    EXPECT_TRUE(is_crossed(pattern, dart));
}

TEST(SheetPositions, lay_panels_out_in_rows_that_do_not_overlap) {
    sim::Pattern pattern;
    for (int i = 0; i < 9; ++i) {
        sim::Panel panel = make_rectangle({-0.3 * i, 1}, {0.5, 1.2 + 0.1 * i});
        panel.name = std::to_string(i);
        pattern.panels.push_back(panel);
    }
    const std::vector<Vec2d> origins = sheet_positions(pattern);
    const auto box = [&](std::size_t i) {
        return Eigen::AlignedBox2d(pattern.panels[i].vertices[0] + origins[i],
                                   pattern.panels[i].vertices[2] + origins[i]);
    };
    for (std::size_t i = 0; i < 9; ++i) {
        for (std::size_t k = i + 1; k < 9; ++k) EXPECT_GT(box(i).exteriorDistance(box(k)), 0.04) << i << " " << k;
    }
    EXPECT_GT(origins[0].x(), -1e-12);
    pattern.panels[3].sheet_position = Vec2d(7, 8);
    std::vector<Vec2d> moved = origins;
    moved[3] = {7, 8};
    EXPECT_EQ(sheet_positions(pattern), moved);
}

}  // namespace

}  // namespace selvedge::editor
