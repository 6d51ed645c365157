#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "sim/mesh/seam_geometry.h"

namespace selvedge {
namespace {

TEST(SeamRestLength, is_the_average_within_the_ease) {
    EXPECT_DOUBLE_EQ(seam_rest_length(1.0, 1.04), 1.02);
    EXPECT_DOUBLE_EQ(seam_rest_length(1.04, 1.0), 1.02);
    EXPECT_DOUBLE_EQ(seam_rest_length(0.3, 0.3), 0.3);
}

TEST(SeamRestLength, is_the_shorter_side_of_gathers) {
    EXPECT_DOUBLE_EQ(seam_rest_length(1.0, 1.3), 1.0);
    EXPECT_DOUBLE_EQ(seam_rest_length(2.2, 1.0), 1.0);
}

TEST(SeamRestLength, takes_another_limit_of_ease) {
    EXPECT_DOUBLE_EQ(seam_rest_length(1.0, 1.3, {.ease = 0.5}), 1.15);
}

TEST(UnfoldAcross, leaves_a_point_where_it_is_when_both_sides_agree) {
    const EdgeCopy edge{{0.1, 0.2}, {0.4, -0.1}};
    const Vec2d opposite(0.7, 0.9);
    EXPECT_LT((unfold_across(edge, edge, opposite) - opposite).norm(), 1e-15);
}

TEST(UnfoldAcross, undoes_any_motion_of_the_other_panel) {
    const EdgeCopy into{{0, 0}, {0, 2}};
    const Vec2d opposite(1, 0.5);
    for (double angle = -3; angle < 3; angle += 0.37) {
        const Eigen::Rotation2Dd turn(angle);
        const Vec2d shift(angle, 1 - angle);
        const EdgeCopy from{turn * into.a + shift, turn * into.b + shift};
        EXPECT_LT((unfold_across(into, from, turn * opposite + shift) - opposite).norm(), 1e-14) << angle;
    }
}

TEST(UnfoldAcross, makes_midpoints_coincide_without_stretching_when_lengths_differ) {
    const EdgeCopy into{{0, 0}, {1, 0}};
    const EdgeCopy from{{5, 5}, {5, 7}};  // twice as long, turned by 90 degrees
    const Vec2d midpoint(5, 6);
    EXPECT_LT((unfold_across(into, from, midpoint) - Vec2d(0.5, 0)).norm(), 1e-15);
    EXPECT_LT((unfold_across(into, from, {5.3, 6}) - Vec2d(0.5, -0.3)).norm(), 1e-15);
    EXPECT_LT((unfold_across(into, from, from.a) - Vec2d(-0.5, 0)).norm(), 1e-15);
}

}  // namespace
}  // namespace selvedge
