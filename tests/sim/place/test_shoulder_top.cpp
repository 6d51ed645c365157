// The height of the shoulders, from which garments hang.
#include "sim/place/shoulder_top.h"

#include <gtest/gtest.h>

#include "sim/place/placement.h"
#include "tests/sim/dress/shapes.h"
#include "tests/sim/place/support.h"
#include "tests/support/bodies.h"
#include "tests/support/posed_body.h"

namespace selvedge::sim::test {
namespace {

TEST(ShoulderTop, lies_over_the_joints_of_the_arms) {
    const MeasuredBody body(mannequin());
    const auto top = find_shoulder_top(body);
    ASSERT_TRUE(top);
    const double joint = body.limbs()[LimbKind::LeftArm].joints.front().centre.y();
    EXPECT_GT(*top, joint + 0.01);
    EXPECT_LT(*top, joint + 0.10);
}

TEST(ShoulderTop, stays_where_it_is_below_a_larger_head) {
    const Body figure = with_large_head(mannequin());
    const auto top = find_shoulder_top(MeasuredBody(figure)), usual = find_shoulder_top(MeasuredBody(mannequin()));
    ASSERT_TRUE(top && usual);
    EXPECT_NEAR(*top, *usual, 1e-3);
}

TEST(ShoulderTop, is_the_same_when_the_arms_are_level) {
    const Body level = shapes::in_t_pose(mannequin());
    const auto top = find_shoulder_top(MeasuredBody(level)), usual = find_shoulder_top(MeasuredBody(mannequin()));
    ASSERT_TRUE(top && usual);
    EXPECT_NEAR(*top, *usual, 0.01);
}

TEST(ShoulderTop, is_none_on_a_column) {
    const Body column = shapes::box(Vec3d(-0.15, 0, -0.1), Vec3d(0.15, 1.5, 0.1), 8);
    EXPECT_FALSE(find_shoulder_top(MeasuredBody(column)));
}

// The smaller head lowers the stature by 4 %, and the trunk and limbs are the same.
TEST(AnchorPanels, leaves_a_tabard_on_the_shoulders_when_the_head_is_smaller) {
    const Body figure = with_head_scaled(mannequin(), 0.7);
    ASSERT_TRUE(find_proportions(figure, find_stature(figure)).is_usual);
    const auto top = find_shoulder_top(MeasuredBody(mannequin()));
    ASSERT_TRUE(top);
    Pattern pattern = tabard(0.4, 0.5, *top - 0.5, 0.2);
    anchor_panels(pattern, MeasuredBody(mannequin()), MeasuredBody(figure));
    for (const Panel& panel : pattern.panels) EXPECT_NEAR(panel.place(panel.vertices[2]).y(), *top, 0.005);
}

}  // namespace
}  // namespace selvedge::sim::test
