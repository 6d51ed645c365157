#include "sim/repair/surface_repair.h"

#include <gtest/gtest.h>

#include "sim/mannequin/mannequin.h"
#include "sim/repair/self_intersections.h"
#include "tests/support/bodies.h"
#include "tests/support/body_checks.h"

namespace selvedge::sim {
namespace {

Body join(Body body, const Body& other) {
    const int offset = static_cast<int>(body.x.size());
    body.x.insert(body.x.end(), other.x.begin(), other.x.end());
    for (const auto& [a, b, c] : other.triangles) body.triangles.push_back({a + offset, b + offset, c + offset});
    return body;
}

Body ball(double x) {
    return shapes::sphere(Vec3d(x, 0.01, 0.02), 1, 9);
}

TEST(SurfaceRepair, keeps_the_indices_of_a_file_where_they_close_the_surface) {
    // Equal vertices with indices of their own, as of lips that touch.
    const Body two =
        join(shapes::box({-0.2, 0, -0.1}, {0.2, 0.8, 0.1}, 4), shapes::box({-0.2, 0.8, -0.1}, {0.2, 1, 0.1}, 4));
    RepairReport report;
    const Surface surface = repair({two.x, two.triangles, {}}, "file", {}, report);
    EXPECT_EQ(report.welded_vertices, 0);
    EXPECT_EQ(report.cuts.edges, 0);
    EXPECT_EQ(surface.x.size(), two.x.size());
    EXPECT_EQ(surface.triangles, two.triangles);
}

TEST(SurfaceRepair, welds_only_at_open_edges) {
    Body two = join(shapes::box({-0.2, 0, -0.1}, {0.2, 0.8, 0.1}, 4), shapes::box({-0.2, 0.8, -0.1}, {0.2, 1, 0.1}, 4));
    two.x.push_back(two.x[std::size_t(two.triangles[0][0])]);  // as a seam of the texture splits a vertex
    two.triangles[0][0] = int(two.x.size()) - 1;
    RepairReport report;
    const Surface surface = repair({two.x, two.triangles, {}}, "file", {}, report);
    EXPECT_EQ(report.welded_vertices, 1);
    EXPECT_EQ(report.pieces, 2);
    EXPECT_EQ(surface.x.size(), two.x.size() - 1);
}

TEST(SelfIntersections, of_one_ball_or_of_two_apart_are_none) {
    EXPECT_TRUE(self_intersections(ball(0)).empty());
    EXPECT_TRUE(self_intersections(join(ball(0), ball(2.1))).empty());
    EXPECT_TRUE(self_intersections(Body{}).empty());
}

TEST(SelfIntersections, of_two_balls_that_overlap_are_those_that_exact_arithmetic_finds) {
    for (const double distance : {0.3, 1.0, 1.7, 1.95}) {
        const Body body = join(ball(0), shapes::sphere(Vec3d(distance, 0.13, -0.07), 0.9, 7));
        const auto pairs = self_intersections(body);
        EXPECT_EQ(static_cast<int>(pairs.size()), count_self_intersections(body)) << distance;
        EXPECT_EQ(pairs.empty(), distance > 1.94) << distance;
    }
}

TEST(SelfIntersections, find_a_needle_through_a_large_triangle) {
    Body body = shapes::box(Vec3d::Zero(), Vec3d(10, 10, 0.1), 1);
    body = join(body, shapes::box(Vec3d(6, 3, -1), Vec3d(6.01, 3.01, 1), 1));
    EXPECT_EQ(static_cast<int>(self_intersections(body).size()), count_self_intersections(body));
    EXPECT_FALSE(self_intersections(body).empty());
}

TEST(SelfIntersections, find_neighbours_that_fold_through_each_other) {
    // Two triangles that share the vertex 0; an edge of the second pierces the first.
    Body body;
    body.x = {{0, 0, 0}, {2, -1, 0}, {2, 1, 0}, {1, 0, -1}, {1.5, 0, 1}};
    body.triangles = {{0, 1, 2}, {0, 3, 4}};
    ASSERT_EQ(self_intersections(body).size(), 1U);
    EXPECT_EQ(self_intersections(body)[0], (std::array{0, 1}));
    body.x[4] = Vec3d(1.5, 0, -0.5);
    EXPECT_TRUE(self_intersections(body).empty());
}

TEST(SelfIntersections, in_the_armpits_of_a_barrel_chest_are_undone_by_wider_shoulders) {
    const Mannequin mannequin = make_mannequin({.sex = Sex::Male, .measures = {.bust = 1.454}});
    EXPECT_TRUE(mannequin.report.messages.empty());
    EXPECT_EQ(count_self_intersections(mannequin.body), 0);
}

TEST(SelfIntersections, that_cannot_be_undone_are_said) {
    const Mannequin mannequin =
        make_mannequin({.sex = Sex::Male, .measures = {.bust = 1.50, .underbust = 0.91, .neck = 0.26}});
    EXPECT_GT(count_self_intersections(mannequin.body), 0);
    ASSERT_FALSE(mannequin.report.messages.empty());
    EXPECT_NE(mannequin.report.messages.back().find("cuts itself near chest"), std::string::npos);
}

// The checks of tests/support must detect faulty bodies.

Body box() {
    return shapes::box(Vec3d::Zero(), Vec3d(1, 2, 3), 3);
}

TEST(BodyChecks, take_a_box) {
    EXPECT_TRUE(is_closed_manifold(box()));
    EXPECT_NEAR(volume(box()), 6, 1e-12);
}

TEST(BodyChecks, see_a_hole_a_turned_triangle_a_doubled_one_and_a_second_piece) {
    Body holed = box();
    holed.triangles.pop_back();
    EXPECT_FALSE(is_closed_manifold(holed));

    Body turned = box();
    std::swap(turned.triangles[5][0], turned.triangles[5][1]);
    EXPECT_FALSE(is_closed_manifold(turned));

    Body doubled = box();
    doubled.triangles.push_back(doubled.triangles[4]);
    EXPECT_FALSE(is_closed_manifold(doubled));

    Body two = box();
    const int offset = static_cast<int>(two.x.size());
    for (const Vec3d& x : box().x) two.x.emplace_back(x + Vec3d(5, 0, 0));
    for (const auto& [a, b, c] : box().triangles) two.triangles.push_back({a + offset, b + offset, c + offset});
    EXPECT_FALSE(is_closed_manifold(two));
}

}  // namespace

}  // namespace selvedge::sim
