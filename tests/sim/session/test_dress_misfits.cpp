// Garments that do not fit are told so, and not by what their drape became.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "sim/body/yielding_flesh.h"
#include "sim/dress/prepared_body.h"
#include "sim/motion/motion_file.h"
#include "sim/session/dress.h"
#include "sim/simulation/simulation.h"
#include "tests/sim/dress/shapes.h"
#include "tests/sim/dress/support.h"
#include "tests/support/mannequin.h"

namespace selvedge::sim::test {
namespace {

// The mannequin, with all girths larger by this factor.
Body wider(double factor) {
    Body body = mannequin();
    for (Vec3d& x : body.x) x = Vec3d(factor * x.x(), x.y(), factor * x.z());
    body.bones.clear();
    body.skin = {};
    body.made_from.clear();
    return body;
}

TEST(DressMisfit, of_a_shirt_that_cannot_close_round_a_body_is_told_as_its_size_alone) {
    DressOptions coarse;
    coarse.max_level = 0;
    const DressReport report = dress(shipped("tshirt"), wider(1.8), coarse).report;
    EXPECT_EQ(outcome_of(report), Outcome::DoesNotFit) << list_faults(report);
    EXPECT_TRUE(std::ranges::all_of(report.faults, [](const DressFault& fault) {
        return fault.kind == "does_not_fit";
    })) << list_faults(report);
}

std::shared_ptr<const PreparedBody> with_arms_down() {
    return std::make_shared<const PreparedBody>(
        MadeBody{.body = std::make_shared<const Body>(posed(mannequin(), find_pose("arms_down", mannequin())))});
}

TEST(DressMisfit, of_a_heap_of_cloth_ends_on_its_way_to_the_body_s_own_pose) {
    const std::shared_ptr<const PreparedBody> arms_down = with_arms_down();
    ASSERT_TRUE(arms_down->stands_otherwise());
    const Pattern skirt = tube(0.42, 0.3, 0.9, 0.2);
    DressOptions options;
    options.max_level = 0;
    const double fall = dress(skirt, *arms_down->stands(), options).report.work;
    options.most_work = fall + 1;
    const DressReport report = dress(skirt, arms_down, options).report;
    EXPECT_EQ(report.stopped_because, "work limit");
    EXPECT_GT(report.work, fall);
}

TEST(DressMisfit, of_a_heap_whose_fall_was_given_up_moves_to_the_body_s_own_pose_without_contact_with_itself) {
    DressOptions options;
    options.max_level = 0;
    options.most_work = 1;
    const auto dressed = dress(tube(0.42, 0.3, 0.9, 0.2), with_arms_down(), options);
    EXPECT_EQ(dressed.report.stopped_because, "work limit");
    EXPECT_FALSE(dressed.simulation->options().self_contact);
}

}  // namespace
}  // namespace selvedge::sim::test
