#include "sim/pattern/outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace selvedge::sim {
namespace {

constexpr double kPi = std::numbers::pi;

Panel two_points(const Vec2d& from, const Vec2d& to) {
    Panel panel;
    panel.vertices = {from, to};
    return panel;
}

OutlineEdge arc(double radius, bool is_large, bool turns_right) {
    return {.start = 0,
            .end = 1,
            .kind = CurveKind::Arc,
            .arc_radius = radius,
            .is_large_arc = is_large,
            .turns_right = turns_right};
}

OutlineEdge cubic(const Vec2d& first, const Vec2d& second) {
    return {.start = 0, .end = 1, .kind = CurveKind::Cubic, .control = {first, second}};
}

double sampled_length(const Panel& panel, const OutlineEdge& edge, int segments) {
    double length = 0;
    for (int i = 0; i < segments; ++i) {
        length += (curve_point(panel, edge, double(i + 1) / segments) - curve_point(panel, edge, double(i) / segments))
                      .norm();
    }
    return length;
}

TEST(Outline, a_line_is_as_long_as_its_chord) {
    const Panel panel = two_points({0, 0}, {0.3, 0.4});
    const OutlineEdge line{.start = 0, .end = 1};
    EXPECT_DOUBLE_EQ(outline_length(panel, line), 0.5);
    EXPECT_TRUE(outline_point(panel, line, 0.25).isApprox(Vec2d(0.075, 0.1)));
}

TEST(Outline, a_half_circle_that_turns_left_lies_right_of_its_chord) {
    const Panel panel = two_points({-1, 0}, {1, 0});
    EXPECT_NEAR(outline_length(panel, arc(1, false, false)), kPi, 1e-12);
    EXPECT_TRUE(outline_point(panel, arc(1, false, false), 0.5).isApprox(Vec2d(0, -1), 1e-12));
    EXPECT_TRUE(outline_point(panel, arc(1, false, true), 0.5).isApprox(Vec2d(0, 1), 1e-12));
}

TEST(Outline, small_and_large_arcs_make_up_the_circle) {
    const Panel panel = two_points({0, 0}, {0.1, 0});
    const double radius = 0.13;
    const double small = outline_length(panel, arc(radius, false, false));
    const double large = outline_length(panel, arc(radius, true, false));
    EXPECT_NEAR(small + large, 2 * kPi * radius, 1e-12);
    for (const bool is_large : {false, true}) {
        for (const bool turns_right : {false, true}) {
            const OutlineEdge edge = arc(radius, is_large, turns_right);
            const Vec2d middle = outline_point(panel, edge, 0.5);
            EXPECT_EQ(middle.y() > 0, turns_right);
            EXPECT_NEAR((outline_point(panel, edge, 1e-9) - panel.vertices[0]).norm(), 0, 1e-8);
            EXPECT_NEAR((outline_point(panel, edge, 1 - 1e-9) - panel.vertices[1]).norm(), 0, 1e-8);
        }
    }
}

TEST(Outline, bezier_lengths_agree_with_fine_sampling) {
    const Panel panel = two_points({0, 0}, {0.4, 0.1});
    const OutlineEdge quadratic{
        .start = 0, .end = 1, .kind = CurveKind::Quadratic, .control = {Vec2d(0.3, -0.3), Vec2d::Zero()}};
    for (const OutlineEdge& edge : {quadratic, cubic({0.1, 0.2}, {0.2, -0.3}), cubic({0.5, 0.2}, {-0.1, 0.2})}) {
        EXPECT_NEAR(outline_length(panel, edge), sampled_length(panel, edge, 200000), 1e-9);
    }
}

TEST(Outline, a_cusp_does_not_spoil_the_length) {
    const Panel panel = two_points({0, 0}, {1, 0});
    const OutlineEdge cusp = cubic({1, 1}, {0, 1});  // the speed is zero at s = 0.5
    EXPECT_NEAR(outline_length(panel, cusp), sampled_length(panel, cusp, 400000), 1e-7);
}

TEST(Outline, equal_fractions_give_equal_lengths) {
    const Panel panel = two_points({0, 0}, {0.4, 0});
    const OutlineEdge edge = cubic({0.01, 0.3}, {0.02, 0.1});  // its speed varies strongly with s
    const int count = 50;
    double least = 1;
    double most = 0;
    for (int i = 0; i < count; ++i) {
        const double chord =
            (outline_point(panel, edge, double(i + 1) / count) - outline_point(panel, edge, double(i) / count)).norm();
        least = std::min(least, chord);
        most = std::max(most, chord);
    }
    EXPECT_LT(most / least, 1.02);
    EXPECT_LT(outline_length(panel, edge) - least * count, 0.02 * outline_length(panel, edge));
}

TEST(Outline, the_ends_are_the_vertices_bit_by_bit) {
    const Panel panel = two_points({0.1, 0.7}, {0.3, 0.2});
    for (const OutlineEdge& edge : {arc(0.4, false, true), cubic({0.5, 0.2}, {-0.1, 0.2})}) {
        EXPECT_EQ(outline_point(panel, edge, 0), panel.vertices[0]);
        EXPECT_EQ(outline_point(panel, edge, 1), panel.vertices[1]);
    }
}

TEST(Outline, a_polyline_keeps_its_distance_from_the_curve) {
    const Panel panel = two_points({0, 0}, {0.4, 0});
    const double allowed = 1e-4;
    for (const OutlineEdge& edge : {arc(0.21, true, false), cubic({0.1, 0.3}, {0.3, -0.3})}) {
        const std::vector<Vec2d> points = outline_polyline(panel, edge, allowed);
        const auto count = static_cast<double>(points.size() - 1);
        double worst = 0;
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const Vec2d middle = curve_point(panel, edge, (double(i) + 0.5) / count);
            const Vec2d along = (points[i + 1] - points[i]).normalized();
            worst = std::max(worst, std::abs(cross2(along, middle - points[i])));
        }
        EXPECT_LE(worst, allowed);
        EXPECT_GT(worst, allowed / 20);
    }
}

TEST(Outline, the_area_of_a_disc_of_two_arcs) {
    Panel panel = two_points({-0.5, 0}, {0.5, 0});
    panel.edges = {arc(0.5, false, false), arc(0.5, false, false)};
    std::swap(panel.edges[1].start, panel.edges[1].end);
    EXPECT_NEAR(outline_area(panel), kPi / 4, 5e-4);
    for (OutlineEdge& edge : panel.edges) edge.turns_right = true;
    EXPECT_NEAR(outline_area(panel), -kPi / 4, 5e-4);
}

}  // namespace
}  // namespace selvedge::sim
