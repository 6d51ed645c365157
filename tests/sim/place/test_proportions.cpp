// Where hips and shoulders are, of people and of figures with other proportions.
#include "sim/place/proportions.h"

#include <gtest/gtest.h>

#include "sim/place/body_girths.h"
#include "sim/place/measured_body.h"
#include "tests/sim/place/support.h"

namespace selvedge::sim::test {
namespace {

double joint_height(const Body& body, const std::string& name) {
    return std::ranges::find(body.bones, name, &Bone::name)->joint.y();
}

TEST(Proportions, of_a_person_are_shares_of_the_stature) {
    const MeasuredBody body(mannequin());
    const Proportions found = find_proportions(mannequin(), body.stature());
    EXPECT_TRUE(found.is_usual);
    EXPECT_EQ(found.at(0.62), body.stature().floor + 0.62 * body.stature().height());
}

TEST(Proportions, of_a_figure_with_a_large_head_are_those_of_its_joints) {
    const Body figure = with_large_head(mannequin());
    const MeasuredBody body(figure);
    const Proportions found = find_proportions(figure, body.stature());
    EXPECT_FALSE(found.is_usual);
    EXPECT_NEAR(found.at(0.525), joint_height(figure, "left_upper_leg"), 1e-9);
    EXPECT_NEAR(found.at(0.8), joint_height(figure, "left_upper_arm"), 1e-9);
    EXPECT_NEAR(found.at(0), 0, 1e-9);
    EXPECT_NEAR(found.at(1), body.stature().crown, 1e-9);
}

TEST(Proportions, of_a_figure_with_a_large_head_leave_its_waist_where_it_is) {
    const Body figure = with_large_head(mannequin());
    const MeasuredBody body(figure), usual(mannequin());
    ASSERT_GT(body.stature().height(), 1.2 * usual.stature().height());
    EXPECT_NEAR(torso_heights(figure, body.stature()).waist, torso_heights(mannequin(), usual.stature()).waist, 0.02);
    EXPECT_FALSE(waist_girth(body));  // its surface does not show where a tape would measure it
}

}  // namespace
}  // namespace selvedge::sim::test
