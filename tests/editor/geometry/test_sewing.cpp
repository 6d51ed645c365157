#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

#include "editor/geometry/outline_edit.h"
#include "editor/geometry/panel_edit.h"
#include "editor/geometry/seam_edit.h"
#include "editor/geometry/sewing.h"
#include "sim/pattern/edge_shape.h"
#include "tests/editor/geometry/geometry_support.h"

namespace selvedge::editor {
namespace {

std::vector<std::string> sewings(const sim::Pattern& pattern) {
    std::vector<std::string> names;
    for (const sim::Seam& seam : pattern.seams) names.push_back(seam.sewing);
    return names;
}

// The right side of the first square is sewn to the left side of the second, which a corner divides at a third of its
// height: its outline goes down, so the parts are of 2/3 and of 1/3.
sim::Pattern one_to_two() {
    sim::Pattern pattern;
    pattern.panels = {unit_square("one"), unit_square("two")};
    pattern.panels[1].translation.x() = 1.5;
    const int corner = split_edge(pattern, {1, 3}, 2.0 / 3);
    move_vertices(pattern, 1, {corner}, {-0.1, 0});
    sew_runs(pattern, {{0, 1}}, {{1, 3}, {1, 4}}, true);
    return pattern;
}

TEST(Sewing, of_one_edge_to_two_is_one_and_of_one_to_one_is_none) {
    sim::Pattern pattern = one_to_two();
    EXPECT_EQ(sewings(pattern), (std::vector<std::string>{"sewing 1", "sewing 1"}));
    EXPECT_EQ(sewing_of(pattern, 1), (std::vector<int>{0, 1}));
    sew_runs(pattern, {{0, 0}}, {{1, 1}}, true);
    EXPECT_EQ(pattern.seams[2].sewing, "");
    EXPECT_EQ(sewing_of(pattern, 2), std::vector<int>{2});
    EXPECT_EQ(one_of_each_sewing(pattern, {0, 1, 2}), (std::vector<int>{0, 2}));
    EXPECT_EQ(first_of_sewing(pattern, 1), 0);
    EXPECT_EQ(first_of_sewing(pattern, 2), 2);
    sew_runs(pattern, {{0, 3}}, {{1, 0, 0, 0.5}, {1, 0, 0.6, 1}}, true);
    EXPECT_EQ(pattern.seams[3].sewing, "sewing 2");
    EXPECT_TRUE(can_be_saved(pattern));
}

TEST(Sewing, keeps_parts_that_are_split_later_in_order) {
    sim::Pattern pattern = one_to_two();
    split_edge(pattern, {0, 1}, 0.5);
    ASSERT_EQ(pattern.seams.size(), 3U);
    EXPECT_EQ(pattern.seams[2].sewing, "sewing 1");
    EXPECT_EQ(sewing_of(pattern, 0), (std::vector<int>{0, 2, 1})) << "the new one is the middle one";
    const auto [first, second] = sewing_lengths(pattern, 2);
    EXPECT_NEAR(first, 1, 1e-9);
    EXPECT_NEAR(second, std::hypot(0.1, 2.0 / 3) + std::hypot(0.1, 1.0 / 3), 1e-9);
}

TEST(Sewing, of_copies_is_their_own) {
    sim::Pattern pattern = one_to_two();
    duplicate_panels(pattern, {0, 1}, {});
    EXPECT_EQ(sewings(pattern), (std::vector<std::string>{"sewing 1", "sewing 1", "sewing 2", "sewing 2"}));
    symmetric_copies(pattern, {0, 1}, false, {3, 0});
    EXPECT_EQ(pattern.seams[4].sewing, "sewing 3");
    EXPECT_EQ(pattern.seams[5].sewing, "sewing 3");
}

TEST(ReverseSewing, splits_the_edge_where_the_corner_then_is) {
    sim::Pattern pattern = one_to_two();
    const sim::Pattern before = pattern;
    const double part = edge_length(pattern, pattern.seams[0].first);
    ASSERT_NE(part, 0.5);
    const std::vector<int> seams = reverse_sewing(pattern, 1);
    EXPECT_EQ(seams.size(), 2U);
    ASSERT_EQ(pattern.seams.size(), 2U);
    EXPECT_EQ(pattern.panels[0].edges.size(), 5U) << "the old point is gone";
    EXPECT_EQ(pattern.panels[0].vertices.size(), 5U);
    EXPECT_NEAR(edge_length(pattern, pattern.seams[0].first), 1 - part, 1e-9);
    EXPECT_FALSE(pattern.seams[0].is_reversed);
    EXPECT_EQ(sewings(pattern), (std::vector<std::string>{"sewing 1", "sewing 1"}));
    EXPECT_TRUE(can_be_saved(pattern));
    reverse_sewing(pattern, 0);
    EXPECT_NEAR(edge_length(pattern, pattern.seams[0].first), part, 1e-9);
    EXPECT_EQ(pattern.panels[1], before.panels[1]);
}

TEST(ReverseSewing, twice_gives_back_what_was_sewn_to_two_panels) {
    sim::Pattern pattern;
    pattern.panels = {unit_square("one"), unit_square("two"), unit_square("three")};
    sew_runs(pattern, {{0, 1}}, {{1, 3}, {2, 3}}, true);
    const auto panel_at_the_bottom = [&] {
        for (const sim::Seam& seam : pattern.seams) {
            if (edge_point(pattern, seam.first, 0.5).y() < 0.5) return seam.second.panel;
        }
        return -1;
    };
    const int before = panel_at_the_bottom();
    reverse_sewing(pattern, 0);
    EXPECT_NE(panel_at_the_bottom(), before) << "the other panel meets the lower half";
    reverse_sewing(pattern, 0);
    EXPECT_EQ(panel_at_the_bottom(), before);
    EXPECT_TRUE(can_be_saved(pattern));
}

TEST(ReverseSewing, of_a_seam_alone_turns_it) {
    sim::Pattern pattern = two_squares();
    EXPECT_EQ(reverse_sewing(pattern, 0), std::vector<int>{0});
    EXPECT_FALSE(pattern.seams[0].is_reversed);
}

TEST(SlideSewing, moves_the_joint_along_the_edge_and_no_corner) {
    sim::Pattern pattern = one_to_two();
    pattern.panels[0].notches = {{.edge = 1, .t = 0.95}};
    const Vec2d notch = edge_point(pattern, {0, 1}, 0.95);
    EXPECT_TRUE(can_slide(pattern, 0, SewingRun::First));
    EXPECT_FALSE(can_slide(pattern, 0, SewingRun::Second)) << "it has corners only";
    const double first = edge_length(pattern, {0, 1}), second = edge_length(pattern, {0, 2});
    slide_sewing(pattern, 0, SewingRun::First, -0.05);
    EXPECT_NEAR(edge_length(pattern, {0, 1}), first - 0.05, 1e-9);
    EXPECT_NEAR(edge_length(pattern, {0, 2}), second + 0.05, 1e-9);
    const sim::Notch& kept = pattern.panels[0].notches[0];
    EXPECT_LT((edge_point(pattern, {0, kept.edge}, kept.t) - notch).norm(), 1e-9) << "a notch stays on the cloth";
    EXPECT_EQ(pattern.seams.size(), 2U);
    const sim::Pattern before = pattern;
    EXPECT_THROW(slide_sewing(pattern, 0, SewingRun::Second, 0.01), GeometryError);
    EXPECT_THROW(slide_sewing(pattern, 0, SewingRun::First, 2), GeometryError);
    EXPECT_EQ(pattern, before);
}

TEST(SlideSewing, moves_both_ends_of_a_part_of_an_edge_on_a_curve_that_keeps_its_shape) {
    sim::Pattern pattern;
    pattern.panels = {unit_square("one"), unit_square("two")};
    sim::OutlineEdge curve = pattern.panels[0].edges[1];
    curve.kind = sim::CurveKind::Cubic;
    curve.control = {Vec2d(1.2, 0.3), Vec2d(1.1, 0.8)};
    set_curve(pattern, {0, 1}, curve);
    const sim::Pattern whole = pattern;
    const double length = edge_length(pattern, {0, 1});
    sew_runs(pattern, {{0, 1, 0.3, 0.6}}, {{1, 3}}, true);
    for (const double by : {0.1, -0.2}) {
        sim::Pattern slid = pattern;
        slide_sewing(slid, 0, SewingRun::First, by);
        EXPECT_NEAR(edge_length(slid, {0, 1}), 0.3 * length + by, 1e-6);
        EXPECT_NEAR(edge_length(slid, {0, 2}), 0.3 * length, 1e-6);
        for (const int edge : {1, 2, 3}) {
            for (const double t : {0.2, 0.5, 0.9}) {
                const Vec2d point = edge_point(slid, {0, edge}, t);
                const sim::Panel& own = whole.panels[0];
                EXPECT_LT(nearest_on_edge(own, own.edges[1], point).distance, 1e-6) << edge << " " << t;
            }
        }
        EXPECT_TRUE(can_be_saved(slid));
    }
}

TEST(EvenSeam, scales_the_whole_second_side_of_a_sewing) {
    sim::Pattern pattern = one_to_two();
    equalize_seam(pattern, 1);
    const auto [first, second] = sewing_lengths(pattern, 0);
    EXPECT_NEAR(first, 1, 1e-9);
    EXPECT_NEAR(second, 1, 1e-6);
    for (const int seam : {0, 1}) {
        const auto [own, other] = seam_lengths(pattern, pattern.seams[static_cast<std::size_t>(seam)]);
        EXPECT_NEAR(own, other, 1e-6) << seam;
    }
}

TEST(EvenSeam, says_that_a_second_side_on_two_panels_is_evened_by_hand) {
    sim::Pattern pattern;
    pattern.panels = {unit_square("one"), unit_square("two"), unit_square("three")};
    sew_runs(pattern, {{0, 1}}, {{1, 3}, {2, 3}}, true);
    EXPECT_THROW(equalize_seam(pattern, 0), GeometryError);
}

}  // namespace
}  // namespace selvedge::editor
