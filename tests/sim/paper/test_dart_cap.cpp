// Over a dart's mouth the cut line follows the folded dart, so that its cloth is caught in the seam.
#include "sim/paper/dart_cap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/paper/cut_line.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/segment_distance.h"
#include "tests/support/darted_panel.h"

namespace selvedge::sim {
namespace {

constexpr double kAllowance = 0.01;  // m

CutLine cut_of(const Panel& panel, const std::vector<Dart>& darts) {
    return cut_line(panel, {.pattern_allowance = kAllowance, .darts = darts});
}

// The image of a point in the line through two others.
Vec2d image(const Vec2d& p, const Vec2d& from, const Vec2d& to) {
    const Vec2d along = (to - from).normalized(), off = p - from;
    return from + 2 * off.dot(along) * along - off;
}

double area_of(const std::vector<Vec2d>& line) {
    double twice = 0;
    for (std::size_t i = 0; i < line.size(); ++i) twice += cross2(line[i], line[(i + 1) % line.size()]);
    return twice / 2;
}

// Distances from the edge's straight line, m, positive outside, of the points of the cut line between both legs, when
// the dart is folded and lies on that edge's side.
std::vector<double> folded_distances(const Panel& panel, const CutLine& cut, int first_leg, int edge) {
    const auto vertex = [&](int v) { return panel.vertices[static_cast<std::size_t>(v)]; };
    const Vec2d begin = vertex(first_leg), tip = vertex(first_leg + 1), end = vertex(first_leg + 2);
    const Vec2d middle = (begin + end) / 2;
    const bool is_before = edge < first_leg;
    const Vec2d from = vertex(edge), along = (vertex((edge + 1) % 10) - from).normalized();
    std::vector<double> distances;
    for (Vec2d p : cut.outline) {
        const bool is_in_wedge = cross2(begin - tip, p - tip) > 1e-7 && cross2(end - tip, p - tip) < -1e-7;
        if (!is_in_wedge) continue;
        // First the half that is farther from the edge is folded on the other one, then both on the edge's side.
        const bool is_nearer_begin = cross2(middle - tip, p - tip) < 0;
        if (is_nearer_begin != is_before) p = image(p, tip, middle);
        p = image(p, tip, is_before ? begin : end);
        distances.push_back(cross2(p - from, along));
    }
    return distances;
}

TEST(DartCap, folded_and_pressed_ends_with_the_allowance) {
    const Panel panel = darted_panel();
    for (const int first_leg : {1, 5}) {
        for (const DartSide side : {DartSide::Before, DartSide::After}) {
            SCOPED_TRACE(std::to_string(first_leg) + (side == DartSide::Before ? " before" : " after"));
            const CutLine cut = cut_of(panel, {{.first_leg = first_leg, .pressed_to = side}});
            ASSERT_EQ(cut.darts.size(), 1U);
            const int edge = side == DartSide::Before ? first_leg - 1 : first_leg + 2;
            const std::vector<double> distances = folded_distances(panel, cut, first_leg, edge);
            ASSERT_FALSE(distances.empty());
            for (const double d : distances) EXPECT_NEAR(d, kAllowance, 1e-6);
        }
    }
}

TEST(DartCap, holds_the_folded_cloth_of_the_whole_mouth) {
    const Panel panel = darted_panel();
    const std::vector<Dart> darts{{.first_leg = 1}, {.first_leg = 5}};
    const CutLine cut = cut_of(panel, darts);
    for (const int tip : {2, 6}) {
        const Vec2d& at = panel.vertices[static_cast<std::size_t>(tip)];
        const Vec2d middle =
            (panel.vertices[static_cast<std::size_t>(tip - 1)] + panel.vertices[static_cast<std::size_t>(tip + 1)]) / 2;
        for (const double share : {0.1, 0.5, 0.95}) EXPECT_TRUE(is_inside(at + share * (middle - at), cut.outline));
    }
    EXPECT_GT(area_of(cut.outline), area_of(cut_of(panel, {}).outline) + 1e-3);
}

TEST(DartCap, marks_legs_and_fold_up_to_the_cut_line) {
    const Panel panel = darted_panel();
    const CutLine cut = cut_of(panel, {{.first_leg = 1}, {.first_leg = 5}});
    ASSERT_EQ(cut.darts.size(), 2U);
    const int first_legs[] = {1, 5};
    for (std::size_t d = 0; d < 2; ++d) {
        const DartLines& dart = cut.darts[d];
        const auto vertex = [&](int v) { return panel.vertices[static_cast<std::size_t>(first_legs[d] + v)]; };
        EXPECT_EQ(dart.begin.on_outline, vertex(0));
        EXPECT_EQ(dart.fold[0], vertex(1));
        EXPECT_EQ(dart.end.on_outline, vertex(2));
        for (const Vec2d& p : {dart.begin.on_cut, dart.end.on_cut, dart.fold[1]})
            EXPECT_LT(distance_to_outline(p, cut.outline), 1e-6);
        EXPECT_LT(distance_to_segment(vertex(0), vertex(1), dart.begin.on_cut), 1e-9);
        EXPECT_LT(distance_to_segment(vertex(2), vertex(1), dart.end.on_cut), 1e-9);
        EXPECT_NEAR((dart.begin.on_cut - vertex(1)).norm(), (dart.end.on_cut - vertex(1)).norm(), 1e-9);
    }
}

TEST(DartCap, keeps_the_allowance_beside_the_mouth) {
    const Panel panel = darted_panel();
    const CutLine cut = cut_of(panel, {{.first_leg = 1}, {.first_leg = 5}});
    for (const int e : {0, 3, 4, 7, 8, 9}) {
        for (const double t : {0.1, 0.5, 0.9}) {
            const Vec2d p = outline_point(panel, panel.edges[static_cast<std::size_t>(e)], t);
            EXPECT_NEAR(distance_to_outline(p, cut.outline), kAllowance, 2e-5) << e << " at " << t;
        }
    }
}

TEST(DartCap, is_left_out_where_the_legs_have_an_allowance_of_their_own) {
    Panel panel = darted_panel();
    panel.edges[1].allowance = panel.edges[2].allowance = 0.005;
    const CutLine cut = cut_of(panel, {{.first_leg = 1}});
    EXPECT_TRUE(cut.darts.empty());
    EXPECT_NEAR(distance_to_outline(outline_point(panel, panel.edges[1], 0.3), cut.outline), 0.005, 1e-6);
}

TEST(DartCap, of_curved_legs_and_edges_meets_the_cut_line_of_the_side) {
    Panel panel = darted_panel();
    panel.edges[0].kind = CurveKind::Quadratic;
    panel.edges[0].control[0] = {0.05, -0.01};
    panel.edges[1].kind = panel.edges[2].kind = CurveKind::Quadratic;
    const Vec2d& tip = panel.vertices[2];
    panel.edges[1].control[0] = {0.102, 0.07};
    panel.edges[2].control[0] = turned_about(tip, image(panel.edges[1].control[0], tip, panel.vertices[1]), 0.3);
    const CutLine cut = cut_of(panel, {{.first_leg = 1}});
    ASSERT_EQ(cut.darts.size(), 1U);
    const DartLines& dart = cut.darts[0];
    EXPECT_NEAR((dart.begin.on_cut - panel.vertices[1]).norm(), (dart.end.on_cut - panel.vertices[3]).norm(), 1e-6);
    EXPECT_LT(distance_to_outline(dart.fold[1], cut.outline), 1e-6);
    EXPECT_NEAR(distance_to_outline(outline_point(panel, panel.edges[0], 0.5), cut.outline), kAllowance, 5e-5);
}

TEST(DartCap, carries_notches_at_the_mouth_out_along_the_leg) {
    Panel panel = darted_panel();
    panel.notches = {{.edge = 1, .t = 0, .kind = NotchKind::V}, {.edge = 2, .t = 1}, {.edge = 1, .t = 0.6}};
    const CutLine cut = cut_of(panel, {{.first_leg = 1}});
    ASSERT_EQ(cut.notches.size(), 3U);
    EXPECT_EQ(cut.notches[0].on_cut, cut.darts[0].begin.on_cut);
    EXPECT_EQ(cut.notches[0].kind, NotchKind::V);
    EXPECT_EQ(cut.notches[1].on_cut, cut.darts[0].end.on_cut);
    EXPECT_EQ(cut.notches[2].on_cut, cut.notches[2].on_outline);
}

}  // namespace
}  // namespace selvedge::sim
