#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "sim/core/error.h"
#include "sim/mesh/sample_outline.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/segment_distance.h"
#include "tests/sim/mesh/shapes.h"

namespace selvedge::sim {
namespace {

// A half disc: a straight diameter along x and an arc above it.
Panel half_disc(double radius) {
    Panel panel = polygon("disc", {{-radius, 0}, {radius, 0}});
    panel.edges[1].kind = CurveKind::Arc;
    panel.edges[1].arc_radius = radius;
    return panel;
}

TEST(SegmentsNeeded, follows_the_target_length_of_a_straight_edge) {
    const Panel panel = rectangle("r", 0.5, 0.01);
    EXPECT_EQ(segments_needed(panel, panel.edges[0], {.target_edge = 0.05}), 10);
    EXPECT_EQ(segments_needed(panel, panel.edges[0], {.target_edge = 0.1}), 5);
    EXPECT_EQ(segments_needed(panel, panel.edges[1], {.target_edge = 0.05}), 1);
}

TEST(SegmentsNeeded, keeps_the_chords_of_arcs_within_the_error) {
    for (double radius : {0.01, 0.03, 0.08, 0.3, 1.0}) {
        const Panel panel = half_disc(radius);
        for (double chord_error : {0.001, 0.003}) {
            const int n = segments_needed(panel, panel.edges[1], {.target_edge = 10, .chord_error = chord_error});
            const auto sagitta = [&](int segments) { return radius * (1 - std::cos(kPi / (2 * segments))); };
            EXPECT_LE(sagitta(n), chord_error * 1.0001) << radius;
            if (n == 1) continue;
            EXPECT_GT(sagitta(n - 1), chord_error * 0.9) << "more than needed at radius " << radius;
        }
    }
}

TEST(SegmentsNeeded, refuses_an_edge_in_wrong_units) {
    const Panel panel = rectangle("huge", 5000, 1);
    EXPECT_THROW(segments_needed(panel, panel.edges[0], {.target_edge = 0.05}), InputError);
}

TEST(SampleOutline, keeps_corners_and_spaces_samples_evenly_along_a_curve) {
    Panel panel = polygon("curved", {{0, 0}, {0.4, 0}, {0.4, 0.5}, {0, 0.3}});
    panel.edges[2].kind = CurveKind::Cubic;
    panel.edges[2].control = {Vec2d(0.35, 0.2), Vec2d(0.2, 0.4)};
    const std::vector<int> segments{3, 2, 7, 4};
    const SampledOutline outline = sample_outline(panel, segments);
    ASSERT_EQ(outline.points.size(), 16U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(outline.runs[i].segments, segments[i]);
        EXPECT_EQ(outline.points[static_cast<std::size_t>(outline.runs[i].first)], panel.vertices[i]);
    }
    const double length = outline_length(panel, panel.edges[2]);
    for (std::size_t i = 5; i < 12; ++i) {
        const double chord = (outline.points[i + 1] - outline.points[i]).norm();
        EXPECT_LE(chord, length / 7 + 1e-9);
        EXPECT_GT(chord, 0.97 * length / 7);
    }
}

TEST(CountSegments, gives_both_sides_of_a_seam_the_larger_count) {
    Pattern pattern;
    pattern.panels = {rectangle("short", 0.5, 0.3), rectangle("long", 0.8, 0.3)};
    pattern.seams = {{{0, 0}, {1, 2}}};
    const auto segments = count_segments(pattern, {.target_edge = 0.05});
    EXPECT_EQ(segments[0][0], 16);
    EXPECT_EQ(segments[1][2], 16);
    EXPECT_EQ(segments[0][2], 10);
}

TEST(CountSegments, gives_the_banks_of_a_slit_one_count_although_one_is_sewn_elsewhere) {
    Pattern pattern;
    pattern.panels = {polygon("slit", {{0, 0}, {0.5, 0}, {0.5, 0.3}, {0.5, 0}, {1, 0}, {1, 1}, {0, 1}}),
                      rectangle("gusset", 0.9, 0.2)};
    pattern.seams = {{{0, 1}, {1, 0}}};
    const auto segments = count_segments(pattern, {.target_edge = 0.05});
    EXPECT_EQ(segments[0][1], 18);
    EXPECT_EQ(segments[0][2], 18);
}

TEST(CountSegments, gives_three_segments_to_an_edge_that_sewing_closes_into_a_ring) {
    Pattern pattern;
    pattern.panels = {rectangle("cuff", 0.06, 0.3)};
    pattern.seams = {{{0, 1}, {0, 3}}};
    const auto segments = count_segments(pattern, {.target_edge = 0.05});
    EXPECT_EQ(segments[0][0], 3);
    EXPECT_EQ(segments[0][2], 3);
}

TEST(CountSegments, keeps_two_straight_edges_apart_whose_ends_are_sewn_together) {
    Pattern pattern;
    pattern.panels = {rectangle("front", 0.04, 0.3), rectangle("back", 0.04, 0.3)};
    pattern.seams = {{{0, 1}, {1, 3}}, {{0, 3}, {1, 1}}};
    const auto segments = count_segments(pattern, {.target_edge = 0.05});
    EXPECT_EQ(segments[0][0], 2);
    EXPECT_EQ(segments[1][0], 2);
}

TEST(CountSegments, makes_a_point_of_an_edge_that_is_shorter_than_a_stitch) {
    Pattern pattern;
    for (const double shortest : {0.001, 0.003})
        pattern.panels.push_back(polygon("p", {{0, 0}, {0.2, 0}, {0.2, 0.3}, {0.2 - shortest, 0.3}, {0, 0.3}}));
    EXPECT_EQ(count_segments(pattern, {.target_edge = 0.1})[0], (std::vector<int>{2, 3, 0, 2, 3}));
    const GarmentMesh mesh = assemble(pattern, {.target_edge = 0.1});
    for (const GarmentTriangle& t : mesh.triangles) {
        const auto shortest =
            std::min((t.u[1] - t.u[0]).norm(), std::min((t.u[2] - t.u[1]).norm(), (t.u[0] - t.u[2]).norm()));
        EXPECT_GT(shortest, t.panel == 0 ? 0.02 : 0.002);
    }
    pattern.seams = {{.first = {0, 2}, .second = {1, 2}}};
    EXPECT_EQ(count_segments(pattern, {.target_edge = 0.1})[0][2], 1) << "sewn to an edge that is not";
}

// A trapezoid like a stick, with ends of 1 mm: two segments would be left, and a triangle has three.
TEST(CountSegments, leaves_a_narrow_panel_three_corners) {
    Pattern pattern;
    pattern.panels = {polygon("stick", {{0, 0}, {0.05, 0}, {0.05, 0.001}, {0, 0.001}})};
    EXPECT_EQ(count_segments(pattern, {.target_edge = 0.05})[0], (std::vector<int>{1, 1, 1, 1}));
    const GarmentMesh mesh = assemble(pattern, {.target_edge = 0.05});
    EXPECT_GE(mesh.triangles.size(), 2U);
    EXPECT_TRUE(check_mesh(mesh).empty());
    pattern.panels = {polygon("speck", {{0, 0}, {0.0015, 0}, {0.0015, 0.001}, {0, 0.001}})};
    EXPECT_EQ(count_segments(pattern, {.target_edge = 0.05})[0], (std::vector<int>{1, 1, 1, 1}));
}

TEST(CountSegments, refuses_seams_that_cannot_be) {
    Pattern pattern;
    pattern.panels = {rectangle("only", 0.5, 0.3)};
    pattern.seams = {{{0, 0}, {0, 4}}};
    EXPECT_THROW(count_segments(pattern, {}), InputError);
    pattern.seams = {{{0, 0}, {1, 0}}};
    EXPECT_THROW(count_segments(pattern, {}), InputError);
    pattern.seams = {{{0, 0}, {0, 0}}};
    EXPECT_THROW(count_segments(pattern, {}), InputError);
}

TEST(FindCrossing, finds_none_in_a_square) {
    EXPECT_FALSE(find_crossing(std::vector<Vec2d>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
}

TEST(FindCrossing, names_the_two_segments_of_a_bow_tie) {
    const auto crossing = find_crossing(std::vector<Vec2d>{{0, 0}, {1, 1}, {1, 0}, {0, 1}});
    ASSERT_TRUE(crossing);
    EXPECT_EQ(*crossing, std::pair(0, 2));
}

TEST(FindCrossing, finds_a_corner_that_touches_the_middle_of_a_segment) {
    EXPECT_TRUE(find_crossing(std::vector<Vec2d>{{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}));
}

TEST(FindCrossing, finds_a_segment_without_length) {
    const auto crossing = find_crossing(std::vector<Vec2d>{{0, 0}, {1, 0}, {1, 0}, {0, 1}});
    ASSERT_TRUE(crossing);
    EXPECT_EQ(*crossing, std::pair(1, 1));
}

TEST(FindCrossing, finds_a_stretch_walked_twice_the_same_way) {
    EXPECT_TRUE(find_crossing(std::vector<Vec2d>{{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 0}, {0, -1}}));
}

TEST(FindCrossing, lets_a_slit_run_in_and_back) {
    EXPECT_FALSE(find_crossing(std::vector<Vec2d>{{0, 0}, {1, 0}, {1, 1}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

TEST(FindCrossing, finds_banks_of_a_slit_that_overlap_in_part) {
    EXPECT_TRUE(find_crossing(std::vector<Vec2d>{{0, 0}, {1, 0}, {1, 1}, {1, 0.5}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

// Outlines of lattice points: some cross, some touch, and some have segments without length.
TEST(FindCrossing, says_the_same_wherever_an_outline_begins) {
    std::mt19937 random(3);
    int crossings = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<Vec2d> outline;
        const std::size_t count = 3 + random() % 5;
        while (outline.size() < count) outline.emplace_back(random() % 6, random() % 6);
        const bool crosses = find_crossing(outline).has_value();
        crossings += crosses ? 1 : 0;
        for (std::size_t turn = 1; turn < count; ++turn) {
            std::rotate(outline.begin(), outline.begin() + 1, outline.end());
            ASSERT_EQ(find_crossing(outline).has_value(), crosses) << trial;
            for (Vec2d& p : outline) std::swap(p.x(), p.y());  // sorted along the other axis
            ASSERT_EQ(find_crossing(outline).has_value(), crosses) << trial;
        }
    }
    EXPECT_GT(crossings, 200);
    EXPECT_LT(crossings, 1800);
}

TEST(FindCrossing, is_quick_for_a_comb_of_many_teeth) {
    std::vector<Vec2d> comb;
    for (int i = 0; i < 50000; ++i) comb.emplace_back(i % 2, i * 1e-4);
    comb.emplace_back(-1, 5);
    comb.emplace_back(-1, 0);
    EXPECT_FALSE(find_crossing(comb));
    comb[25000].x() = -2;
    EXPECT_TRUE(find_crossing(comb));
}

TEST(Weld, gives_near_points_the_coordinates_of_the_first) {
    std::vector<Vec2d> points{{0, 0}, {1, 0}, {3e-7, -2e-7}, {1, 1e-5}};
    weld(points);
    EXPECT_EQ(points[2], points[0]);
    EXPECT_NE(points[3], points[1]);
}

TEST(IsInside, tells_the_notch_of_a_concave_outline_from_its_body) {
    const std::vector<Vec2d> outline{{0, 0}, {2, 0}, {2, 2}, {1, 0.5}, {0, 2}};
    EXPECT_TRUE(is_inside({1, 0.25}, outline));
    EXPECT_TRUE(is_inside({0.2, 1.2}, outline));
    EXPECT_FALSE(is_inside({1, 1}, outline));
    EXPECT_FALSE(is_inside({3, 1}, outline));
}

TEST(SmallestAngle, is_found_at_whatever_corner) {
    const Vec2d a(0, 0);
    const Vec2d b(1, 0);
    const Vec2d c(0, std::sqrt(3.0));
    EXPECT_NEAR(smallest_angle(a, b, c), kPi / 6, 1e-15);
    EXPECT_NEAR(smallest_angle(b, c, a), kPi / 6, 1e-15);
    EXPECT_NEAR(smallest_angle(c, a, b), kPi / 6, 1e-15);
    EXPECT_EQ(smallest_angle(a, b, b), 0);
}

TEST(Weld, leaves_numbers_alone_that_are_not_finite) {
    std::vector<Vec2d> points{{0, 0}, {std::nan(""), 0}};
    weld(points);
    EXPECT_FALSE(points[1].allFinite());
}

TEST(DistanceToSegment, is_measured_to_the_nearer_end_beyond_it) {
    EXPECT_DOUBLE_EQ(distance_to_segment({2, 0}, {0, 0}, {1, 0}), 1);
    EXPECT_DOUBLE_EQ(distance_to_segment({0.5, 2}, {0, 0}, {1, 0}), 2);
    EXPECT_DOUBLE_EQ(distance_to_segment({3, 4}, {0, 0}, {0, 0}), 5);
}

}  // namespace

}  // namespace selvedge::sim
