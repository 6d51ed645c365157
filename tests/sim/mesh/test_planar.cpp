#include <gtest/gtest.h>

#include "sim/mesh/planar.h"
#include "tests/sim/mesh/shapes.h"

namespace selvedge {
namespace {

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
}  // namespace selvedge
