// Where a body is over time: poses, a motion that is played, paused and sought, and back to the start.
#include <gtest/gtest.h>
#include <algorithm>
#include <memory>
#include <vector>

#include "sim/body/skin.h"
#include "sim/motion/grounding.h"
#include "sim/motion/motion_file.h"
#include "sim/session/body_mover.h"
#include "tests/sim/session/session_support.h"

namespace selvedge::sim::test {
namespace {

constexpr double kFrame = 1.0 / 30;  // s

class BodyMoverOnMannequin : public testing::Test {
 protected:
    std::shared_ptr<const Clip> clip(const std::string& name) const {
        return std::make_shared<const Clip>(find_motion(name, *body_));
    }
    double to(const Pose& pose) const { return distance_between(*body_, mover_.pose(), pose); }
    // Advances, and returns the greatest speed of a joint on the way, m/s.
    double advance(double seconds) {
        double fastest = 0;
        for (double t = 0; t < seconds - 1e-9; t += kFrame) {
            const Pose before = mover_.pose();
            mover_.advance(kFrame);
            fastest = std::max(fastest, to(before) / kFrame);
        }
        return fastest;
    }
    double until_arrived(double at_most) {
        double t = 0;
        for (; t < at_most && !mover_.has_arrived(); t += kFrame) mover_.advance(kFrame);
        return t;
    }

    std::shared_ptr<const Body> body_ = session_body();
    BodyMover mover_{body_};
};

TEST_F(BodyMoverOnMannequin, stands_at_rest_until_it_is_asked) {
    EXPECT_TRUE(mover_.has_arrived());
    EXPECT_TRUE(mover_.is_at_start_pose());
    advance(1);
    EXPECT_LT(to(rest_pose(*body_)), 1e-9);
    mover_.play();
    EXPECT_FALSE(mover_.is_playing()) << "there is no motion";
    mover_.seek(0.5);
    EXPECT_TRUE(mover_.has_arrived());
}

TEST_F(BodyMoverOnMannequin, goes_to_a_pose_within_a_second_and_a_half_and_back) {
    mover_.go_to(find_pose("A", *body_));
    EXPECT_FALSE(mover_.is_at_start_pose());
    EXPECT_LT(advance(0.7), MoverOptions{}.max_speed);
    EXPECT_FALSE(mover_.has_arrived());
    advance(0.85);
    EXPECT_TRUE(mover_.has_arrived());
    EXPECT_LT((hips_of(*body_, mover_.pose()) - hips_of(*body_, rest_pose(*body_))).head<1>().norm(), 1e-9);
    mover_.go_to(rest_pose(*body_));
    advance(1.55);
    EXPECT_TRUE(mover_.is_at_start_pose());
}

TEST_F(BodyMoverOnMannequin, takes_longer_for_a_longer_way) {
    mover_.go_to(find_pose("arms_up", *body_));
    EXPECT_LT(advance(10), 1.05 * MoverOptions{}.max_speed);
    EXPECT_TRUE(mover_.has_arrived());
}

TEST_F(BodyMoverOnMannequin, turns_to_another_pose_while_it_is_under_way_without_a_jump) {
    mover_.go_to(find_pose("T", *body_));
    advance(0.6);
    const Pose under_way = mover_.pose();
    mover_.go_to(find_pose("stride", *body_));
    EXPECT_LT(to(under_way), 1e-9);
    EXPECT_LT(advance(10), 1.05 * MoverOptions{}.max_speed);
    EXPECT_TRUE(mover_.has_arrived());
}

TEST_F(BodyMoverOnMannequin, goes_over_into_a_motion_and_plays_it_at_its_speed) {
    const auto walk = clip("walk");
    mover_.set_clip(walk);
    mover_.set_playback({.speed = 0.5});
    EXPECT_TRUE(mover_.has_arrived()) << "a motion alone moves nothing";
    mover_.play();
    advance(1.2);
    EXPECT_TRUE(mover_.is_blending());
    EXPECT_EQ(mover_.time(), 0) << "the motion begins when the body is there";
    while (mover_.is_blending()) mover_.advance(kFrame);
    advance(0.6);
    EXPECT_NEAR(mover_.time(), 0.3, 1e-6);
    Pose expected = sample(*body_, *walk, 0.3), first = sample(*body_, *walk, 0);
    Vec3d by = hips_of(*body_, rest_pose(*body_)) - hips_of(*body_, first);
    by.y() = 0;
    shift(*body_, expected, by);
    EXPECT_LT(to(expected), 1e-6);
}

TEST_F(BodyMoverOnMannequin, walks_on_over_the_end_of_a_cycle_without_a_jump) {
    const auto walk = clip("walk");
    mover_.set_clip(walk);
    mover_.play();
    while (mover_.is_blending()) mover_.advance(kFrame);
    const double in_first = advance(walk->seconds / 2);
    const double over_end = advance(3 * walk->seconds);
    EXPECT_LT(over_end, 1.5 * in_first);
    EXPECT_LT(mover_.time(), walk->seconds);
    EXPECT_GT(mover_.way().norm(), 2) << "m";
}

TEST_F(BodyMoverOnMannequin, stops_at_the_end_of_a_motion_that_is_not_to_be_repeated) {
    const auto sit = clip("sit");
    mover_.set_clip(sit);
    mover_.set_playback({.is_loop = false});
    mover_.play();
    advance(10);
    EXPECT_FALSE(mover_.is_playing());
    EXPECT_TRUE(mover_.has_arrived());
    EXPECT_NEAR(mover_.time(), sit->seconds, 1e-9);
    mover_.play();
    EXPECT_EQ(mover_.time(), 0) << "again from its start";
    EXPECT_TRUE(mover_.is_blending());
}

TEST_F(BodyMoverOnMannequin, goes_back_to_the_start_of_a_motion_that_is_repeated) {
    mover_.set_clip(clip("sit"));
    mover_.play();
    EXPECT_LT(advance(8), 1.6 * MoverOptions{}.max_speed) << "sitting down, and back up";
    EXPECT_TRUE(mover_.is_playing());
}

TEST_F(BodyMoverOnMannequin, is_limited_in_speed_and_acceleration_while_it_seeks) {
    const auto walk = clip("walk");
    mover_.set_clip(walk);
    std::vector<double> speeds{0};
    for (int i = 0; i < 300; ++i) {
        if (i < 60) mover_.seek(walk->seconds * (i % 7) / 7.0);  // a hasty hand
        const Pose before = mover_.pose();
        mover_.advance(kFrame);
        speeds.push_back(to(before) / kFrame);
        EXPECT_LT(speeds.back(), 1.1 * MoverOptions{}.max_speed);
        EXPECT_LT(speeds.back() - speeds[speeds.size() - 2], 1.5 * MoverOptions{}.max_acceleration * kFrame + 0.02);
    }
    EXPECT_TRUE(mover_.has_arrived());
    EXPECT_NEAR(mover_.time(), walk->seconds * 3 / 7, 1e-6);
    EXPECT_FALSE(mover_.is_playing());
}

TEST_F(BodyMoverOnMannequin, seeks_within_the_present_cycle_and_the_length_of_the_motion) {
    const auto walk = clip("walk");
    mover_.set_clip(walk);
    mover_.play();
    while (mover_.is_blending()) mover_.advance(kFrame);
    advance(2.5 * walk->seconds);
    const double far = mover_.way().norm();
    mover_.seek(1e9);
    EXPECT_LE(mover_.time(), walk->seconds);
    EXPECT_GT(mover_.time(), 0.99 * walk->seconds);
    until_arrived(10);
    EXPECT_GT(mover_.way().norm(), far - 0.1) << "m: not back over the cycles";
    mover_.seek(std::numeric_limits<double>::quiet_NaN());
    mover_.advance(kFrame);
    for (const Transform& bone : mover_.pose().bones) EXPECT_TRUE(bone.rotation.coeffs().allFinite());
}

TEST_F(BodyMoverOnMannequin, stays_where_it_is_when_it_is_paused) {
    mover_.set_clip(clip("walk"));
    mover_.play();
    advance(0.5);
    mover_.pause();
    EXPECT_TRUE(mover_.has_arrived());
    EXPECT_EQ(advance(1), 0);
    mover_.play();
    advance(3);
    mover_.pause();
    EXPECT_TRUE(mover_.has_arrived());
    EXPECT_GT(mover_.time(), 0);
    mover_.play();
    EXPECT_FALSE(mover_.is_blending()) << "it is in the motion already";
}

TEST_F(BodyMoverOnMannequin, goes_on_with_what_it_was_to_do_after_it_was_dressed_anew) {
    mover_.set_clip(clip("walk"));
    mover_.play();
    advance(5);
    mover_.stand_at_start();
    EXPECT_LT(to(rest_pose(*body_)), 1e-9);
    EXPECT_LT(mover_.way().norm(), 1e-9);
    EXPECT_TRUE(mover_.is_playing());
    EXPECT_FALSE(mover_.has_arrived());
    EXPECT_LT(advance(1.4), MoverOptions{}.max_speed);
}

TEST_F(BodyMoverOnMannequin, has_nothing_to_do_back_at_the_start) {
    mover_.set_clip(clip("walk"));
    mover_.play();
    advance(5);
    mover_.back_to_start();
    EXPECT_TRUE(mover_.has_arrived());
    EXPECT_TRUE(mover_.is_at_start_pose());
    EXPECT_EQ(mover_.time(), 0);
    EXPECT_LT(to(rest_pose(*body_)), 1e-9);
}

TEST_F(BodyMoverOnMannequin, follows_a_pose_that_changes_all_the_time) {
    const Pose arms_up = find_pose("arms_up", *body_), rest = rest_pose(*body_);
    double fastest = 0;
    for (int i = 1; i <= 60; ++i) {  // a hand that takes 2 s
        mover_.follow(blend(rest, arms_up, i / 60.0));
        fastest = std::max(fastest, advance(kFrame));
    }
    EXPECT_LT(fastest, 1.05 * MoverOptions{}.max_speed) << "m/s";
    EXPECT_FALSE(mover_.is_at_start_pose());
    EXPECT_LT(until_arrived(2), 1.0) << "s: it has come along";
    EXPECT_LT(to(arms_up), 0.05) << "m: but for its hips, which stay over their place";
    mover_.follow(rest);
    EXPECT_LT(until_arrived(3), 3);
    EXPECT_TRUE(mover_.is_at_start_pose());
    mover_.follow(rest);
    EXPECT_TRUE(mover_.has_arrived());
    EXPECT_TRUE(mover_.is_at_start_pose());
}

}  // namespace
}  // namespace selvedge::sim::test
