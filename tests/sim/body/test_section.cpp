#include "sim/body/section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/bodies.h"

namespace selvedge::sim {
namespace {

Plane level(double y) {
    return {.point = Vec3d(0, y, 0), .normal = Vec3d::UnitY()};
}

Body unit_box(int cells) {
    return shapes::box(Vec3d::Zero(), Vec3d::Ones(), cells);
}

void append(Body& body, const Body& other) {
    const int offset = static_cast<int>(body.x.size());
    body.x.insert(body.x.end(), other.x.begin(), other.x.end());
    for (const auto& [a, b, c] : other.triangles) body.triangles.push_back({a + offset, b + offset, c + offset});
}

TEST(Section, of_a_box_is_one_square) {
    const auto loops = section(unit_box(4), level(0.6));
    ASSERT_EQ(loops.size(), 1U);
    EXPECT_NEAR(loops[0].area, 1, 1e-12);
    EXPECT_TRUE(loops[0].centre.isApprox(Vec3d(0.5, 0.6, 0.5), 1e-12));
    EXPECT_NEAR(tape_length(loops[0], level(0.6)), 4, 1e-12);
}

TEST(Section, goes_round_in_order) {
    const auto loops = section(unit_box(4), level(0.6));
    ASSERT_EQ(loops.size(), 1U);
    double perimeter = 0;
    const auto& points = loops[0].points;
    for (std::size_t i = 0; i < points.size(); ++i) perimeter += (points[(i + 1) % points.size()] - points[i]).norm();
    EXPECT_NEAR(perimeter, 4, 1e-12);
}

TEST(Section, through_a_whole_row_of_vertices_is_the_same_square) {
    const auto loops = section(unit_box(4), level(0.5));
    ASSERT_EQ(loops.size(), 1U);
    EXPECT_NEAR(loops[0].area, 1, 1e-12);
    EXPECT_NEAR(tape_length(loops[0], level(0.5)), 4, 1e-12);
}

TEST(Section, in_the_plane_of_a_face_counts_for_one_side_only) {
    EXPECT_EQ(section(unit_box(2), level(0)).size(), 1U);
    EXPECT_TRUE(section(unit_box(2), level(1)).empty());
}

TEST(Section, that_touches_only_a_corner_is_empty) {
    const Vec3d diagonal = Vec3d::Ones().normalized();
    EXPECT_TRUE(section(unit_box(2), {.point = Vec3d::Zero(), .normal = diagonal}).empty());
    EXPECT_TRUE(section(unit_box(2), {.point = Vec3d::Ones(), .normal = diagonal}).empty());
}

TEST(Section, beside_the_body_is_empty) {
    EXPECT_TRUE(section(unit_box(2), level(1.5)).empty());
    EXPECT_FALSE(nearest_loop({}, Vec3d::Zero()).has_value());
}

TEST(Section, of_a_sphere_is_its_circle) {
    const Plane plane{.point = Vec3d(0.1, 0.2, 0.3), .normal = Vec3d(1, 2, -1).normalized()};
    const auto loops = section(shapes::sphere(Vec3d(0.1, 0.2, 0.3), 0.5, 40), plane);
    ASSERT_EQ(loops.size(), 1U);
    EXPECT_NEAR(loops[0].area, std::numbers::pi * 0.25, 2e-3);
    EXPECT_NEAR(tape_length(loops[0], plane), std::numbers::pi, 3e-3);
    EXPECT_NEAR((loops[0].centre - plane.point).norm(), 0, 1e-3);
}

TEST(Section, gives_a_loop_for_each_part_and_the_nearest_is_found) {
    Body body = unit_box(2);
    append(body, shapes::box(Vec3d(3, 0, 0), Vec3d(4, 1, 1), 2));
    const auto loops = section(body, level(0.3));
    ASSERT_EQ(loops.size(), 2U);
    EXPECT_NEAR(nearest_loop(loops, Vec3d(3.1, 0, 0))->centre.x(), 3.5, 1e-12);
    EXPECT_NEAR(nearest_loop(loops, Vec3d(0.9, 0, 0))->centre.x(), 0.5, 1e-12);
}

TEST(Section, of_an_open_surface_leaves_out_what_does_not_close) {
    Body body = unit_box(2);
    body.triangles.erase(body.triangles.begin());  // a triangle of the face x = 0, below y = 0.5
    EXPECT_TRUE(section(body, level(0.25)).empty());
    EXPECT_EQ(section(body, level(0.75)).size(), 1U);
}

TEST(Section, gives_equal_bits_each_time) {
    const Body body = shapes::sphere(Vec3d::Zero(), 1, 12);
    const auto first = section(body, level(0.37));
    const auto second = section(body, level(0.37));
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].points, second[i].points);
}

TEST(LevelSections, have_the_bits_of_sections_at_every_height) {
    Body body = shapes::sphere(Vec3d(0, 0.3, 0), 1, 12);
    append(body, unit_box(4));
    const LevelSections sections(body);
    std::vector<double> heights{-2, -0.7, 1.3, 5};  // also below, above, and through vertices
    for (int i = 0; i <= 100; ++i) heights.push_back(-0.75 + 0.021 * i);
    for (const Vec3d& x : body.x) heights.push_back(x.y());
    for (const double y : heights) {
        const auto expected = section(body, level(y)), found = sections.at(y);
        ASSERT_EQ(found.size(), expected.size()) << y;
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_EQ(found[i].points, expected[i].points);
            EXPECT_EQ(found[i].centre, expected[i].centre);
        }
    }
    EXPECT_TRUE(LevelSections(Body{}).at(0).empty());
}

TEST(TapeLength, spans_a_hollow) {
    // An L of three unit squares: the tape cuts across the missing fourth.
    SectionLoop loop;
    for (const auto& [x, z] : {std::pair{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}})
        loop.points.emplace_back(x, 0, z);
    EXPECT_NEAR(tape_length(loop, level(0)), 6 + std::numbers::sqrt2, 1e-12);
}

TEST(TapeLength, does_not_depend_on_how_finely_the_loop_is_parted) {
    const Body coarse = unit_box(1);
    const Body fine = unit_box(9);
    const Plane tilted{.point = Vec3d(0.5, 0.5, 0.5), .normal = Vec3d(0.2, 1, -0.1).normalized()};
    const auto coarse_loops = section(coarse, tilted);
    const auto fine_loops = section(fine, tilted);
    ASSERT_EQ(coarse_loops.size(), 1U);
    ASSERT_EQ(fine_loops.size(), 1U);
    EXPECT_NEAR(tape_length(coarse_loops[0], tilted), tape_length(fine_loops[0], tilted), 1e-12);
    EXPECT_NEAR(coarse_loops[0].area, fine_loops[0].area, 1e-12);
}

TEST(HeightRange, is_that_of_the_surface) {
    const HeightRange range = height_range(shapes::box(Vec3d(0, -0.25, 0), Vec3d(1, 1.5, 1), 1));
    EXPECT_EQ(range.low, -0.25);
    EXPECT_EQ(range.high, 1.5);
    EXPECT_EQ(height_range(Body{}).high, 0);
}

}  // namespace
}  // namespace selvedge::sim
