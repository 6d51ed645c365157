// A body with pieces that turn about joints.
#include "sim/collide/jointed_collider.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>
#include <vector>

#include "tests/support/bodies.h"

namespace selvedge::sim::test {
namespace {

constexpr float kQuarterTurn = std::numbers::pi_v<float> / 2;
constexpr float kError = 0.002F;  // m, of the field of the trunk

// A cube of 20 cm about the origin, and a bar of 40 cm that sticks out of it in the direction of x.
JointedCollider cube_with_bar() {
    return {shapes::box(Vec3d(-0.1, -0.1, -0.1), Vec3d(0.1, 0.1, 0.1), 8),
            {{.surface = shapes::box(Vec3d(0.1, -0.02, -0.02), Vec3d(0.5, 0.02, 0.02), 4), .joint = Vec3d(0.1, 0, 0)}}};
}

std::vector<Vec3f> points_of(const Body& body) {
    std::vector<Vec3f> points;
    for (const Vec3d& x : body.x) points.push_back(x.cast<float>());
    return points;
}

TEST(JointedCollider, is_the_union_of_its_parts) {
    const JointedCollider body = cube_with_bar();
    EXPECT_NEAR(body.contact({-0.11F, 0, 0}).distance, 0.01F, kError);
    EXPECT_NEAR(body.contact({0.3F, 0.03F, 0}).distance, 0.01F, 1e-5F);
    EXPECT_NEAR(body.contact({0.3F, 0.03F, 0}).normal.y(), 1, 1e-5F);
    EXPECT_NEAR(body.contact({0.3F, 0.015F, 0}).distance, -0.005F, 1e-5F);
    ASSERT_TRUE(body.first_hit({0.3F, 0.5F, 0}, {0.3F, -0.5F, 0}).has_value());
    EXPECT_NEAR(body.first_hit({0.3F, 0.5F, 0}, {0.3F, -0.5F, 0})->point.y(), 0.02F, 1e-5F);
}

TEST(JointedCollider, turns_a_piece_about_its_joint) {
    JointedCollider body = cube_with_bar();
    body.turn(0, Eigen::Quaternionf(Eigen::AngleAxisf(kQuarterTurn, Vec3f::UnitZ())));
    EXPECT_GE(body.contact({0.3F, 0.01F, 0}).distance, body.band());
    EXPECT_NEAR(body.contact({0.13F, 0.3F, 0}).distance, 0.01F, 1e-4F);
    EXPECT_NEAR(body.contact({0.13F, 0.3F, 0}).normal.x(), 1, 1e-4F);
    EXPECT_TRUE(body.meets_piece(0, {0, 0.3F, 0}, {1, 0.3F, 0}));
    EXPECT_FALSE(body.meets_piece(0, {0.3F, 0.5F, 0}, {0.3F, -0.5F, 0}));
    ASSERT_TRUE(body.first_hit({1, 0.3F, 0}, {0, 0.3F, 0}).has_value());
    EXPECT_NEAR(body.first_hit({1, 0.3F, 0}, {0, 0.3F, 0})->normal.x(), 1, 1e-4F);
}

TEST(JointedCollider, gives_a_piece_another_shape) {
    JointedCollider body = cube_with_bar();
    body.reshape(0, points_of(shapes::box(Vec3d(0.1, -0.05, -0.05), Vec3d(0.4, 0.05, 0.05), 4)));
    EXPECT_NEAR(body.contact({0.3F, 0.06F, 0}).distance, 0.01F, 1e-5F);
    EXPECT_GE(body.contact({0.5F, 0, 0}).distance, body.band());
}

TEST(JointedCollider, knows_how_deep_a_point_is_in_a_thick_piece) {
    JointedCollider body = cube_with_bar();
    body.reshape(0, points_of(shapes::box(Vec3d(0.05, -0.09, -0.09), Vec3d(0.5, 0.09, 0.09), 4)));
    EXPECT_NEAR(body.contact({0.3F, 0, 0}).distance, -0.09F, 1e-5F);
    EXPECT_NEAR(body.contact({0.105F, 0, 0}).distance, -0.055F, 1e-5F) << "near the trunk";
    ContactBlock block;
    for (std::size_t i = 0; i < kContactLanes; ++i) block.set_point(i, {0.3F, 0, 0});
    body.contacts({&block, 1}, 0.0032F);
    for (const float distance : block.distance) EXPECT_NEAR(distance, -0.09F, 1e-5F);
}

// The contact cache lets a point move by the distance that it was given.
TEST(JointedCollider, gives_no_distance_that_is_too_large) {
    const JointedCollider body = cube_with_bar();
    for (const float height : {0.021F, 0.03F, 0.05F, 0.1F}) {
        ContactBlock block;
        for (std::size_t i = 0; i < kContactLanes; ++i) block.set_point(i, {0.4F, height, 0});
        body.contacts({&block, 1}, 0.0032F);
        for (const float distance : block.distance) EXPECT_LE(distance, height - 0.02F + body.max_error());
    }
}

TEST(JointedCollider, lets_slots_meet_the_trunk_only) {
    const JointedCollider body = cube_with_bar();
    ContactBlock block;
    for (std::size_t i = 0; i < kContactLanes; ++i) block.set_point(i, {0.3F, 0.015F, 0});
    const std::array<std::uint16_t, 1> trunk_only{0x5555};
    body.contacts_apart({&block, 1}, trunk_only, 0.0032F);
    for (std::size_t i = 0; i < kContactLanes; ++i) EXPECT_EQ(block.distance[i] < 0, i % 2 == 1) << i;
}

}  // namespace
}  // namespace selvedge::sim::test
