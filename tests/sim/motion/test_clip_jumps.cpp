#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "sim/motion/clip_jumps.h"
#include "sim/motion/motion_file.h"
#include "tests/sim/motion/bvh_figure.h"
#include "tests/sim/motion/support.h"
#include "tests/support/mannequin.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kLeftArm = 6, kLeftLeg = 9;  // of figure_in_t_pose()

// Stands and swings its left arm a little. `seconds` at that rate.
std::vector<FigureFrame> swaying(double seconds, double rate, const Vec3d& place) {
    std::vector<FigureFrame> frames;
    for (int k = 0; k <= int(seconds * rate); ++k) {
        frames.push_back(standing_frame(figure_in_t_pose(), place));
        frames.back().turns[kLeftArm].z() += 10 * std::sin(2 * k / rate);
    }
    return frames;
}

FigureFrame t_pose() {
    FigureFrame frame = standing_frame(figure_in_t_pose(), {0, 90, 0});
    std::ranges::fill(frame.turns, Vec3d::Zero());
    return frame;
}

Clip motion_of(const std::vector<FigureFrame>& frames, double rate) {
    const TemporaryFolder folder;
    return find_motion(write_bvh(folder / "motion.bvh", figure_in_t_pose(), frames, rate).string(), test::mannequin());
}

// m/s, of any joint of the mannequin.
double greatest_speed(const Clip& clip) {
    const Body& body = test::mannequin();
    constexpr double kStep = 1.0 / 240;
    double greatest = 0;
    for (double t = kStep; t <= clip.seconds; t += kStep)
        for (std::size_t i = 0; i < kJointCount; ++i)
            greatest = std::max(greatest, (joint_at(body, sample(body, clip, t), Joint(i)) -
                                           joint_at(body, sample(body, clip, t - kStep), Joint(i)))
                                                  .norm() /
                                              kStep);
    return greatest;
}

TEST(ClipJumps, from_a_t_pose_in_the_first_frames_are_left_out_at_any_rate) {
    for (const double rate : {10.0, 25.0, 30.0, 60.0, 120.0}) {
        for (const std::size_t held : {1U, 2U}) {
            std::vector<FigureFrame> frames = swaying(2, rate, {30, 90, 40});
            frames.insert(frames.begin(), held, t_pose());
            const Clip clip = motion_of(frames, rate);
            EXPECT_NEAR(clip.seconds, 2, 1e-3) << rate;
            EXPECT_LT(greatest_speed(clip), 0.5) << rate;
            ASSERT_EQ(clip.notes.size(), 1U) << rate;
            EXPECT_TRUE(clip.notes[0].starts_with("the motion jumps by ")) << clip.notes[0];
            EXPECT_TRUE(clip.notes[0].ends_with(" from a pose at its start: its first " +
                                                moment_text(double(held) / rate) + " are left out"))
                << clip.notes[0];
        }
    }
}

TEST(ClipJumps, to_a_t_pose_at_the_end_are_left_out) {
    std::vector<FigureFrame> frames = swaying(2, 60, {0, 90, 0});
    frames.insert(frames.end(), 3, t_pose());
    const Clip clip = motion_of(frames, 60);
    EXPECT_NEAR(clip.seconds, 2, 1e-3);
    EXPECT_LT(greatest_speed(clip), 0.5);
    ASSERT_EQ(clip.notes.size(), 1U);
    EXPECT_TRUE(clip.notes[0].ends_with(" to a pose at its end: its last 0.05 s are left out")) << clip.notes[0];
}

TEST(ClipJumps, are_not_blended_into_the_motion_when_they_lie_in_a_start_that_is_left_out) {
    const std::vector<FigureFrame> kept = swaying(2, 30, {100, 90, 0});
    std::vector<FigureFrame> frames(9, t_pose());
    for (std::size_t k = 3; k < frames.size(); ++k) frames[k].turns[kLeftArm] = {0, 0, -80};  // one arm flips
    frames.insert(frames.end(), kept.begin(), kept.end());
    const Clip clip = motion_of(frames, 30), wanted = motion_of(kept, 30);
    ASSERT_EQ(clip.notes.size(), 1U) << clip.notes.back();
    EXPECT_TRUE(clip.notes[0].ends_with(" from a pose at its start: its first 0.30 s are left out")) << clip.notes[0];
    const Body& body = test::mannequin();
    for (const double t : {0.0, 0.05, 0.1, 0.5}) {
        const auto hand = [&](const Clip& motion) -> Vec3d {
            const Pose pose = sample(body, motion, t);
            return joint_at(body, pose, Joint::LeftHand) - joint_at(body, pose, Joint::LeftUpperArm);
        };
        EXPECT_LT((hand(clip) - hand(wanted)).norm(), 0.01) << t;
    }
}

TEST(ClipJumps, between_two_takes_are_blended_over_the_longer_the_farther) {
    for (const double place : {0.0, 200.0}) {  // cm
        std::vector<FigureFrame> frames = swaying(2, 30, {0, 90, 0});
        std::vector<FigureFrame> take = swaying(3, 30, {place, 90, 0});
        for (FigureFrame& frame : take) frame.turns[kLeftArm].z() += 80;
        frames.insert(frames.end(), take.begin(), take.end());
        const Clip clip = motion_of(frames, 30);
        EXPECT_NEAR(clip.seconds, 5 + 1 / 30.0, 1e-3);
        EXPECT_LT(greatest_speed(clip), 6) << place;
        ASSERT_EQ(clip.notes.size(), 1U);
        EXPECT_NE(clip.notes[0].find(" at 2.03 s: blended over "), std::string::npos) << clip.notes[0];
        const Body& body = test::mannequin();
        EXPECT_GT((joint_at(body, sample(body, clip, 4), Joint::LeftHand) -
                   joint_at(body, sample(body, clip, 4), Joint::LeftUpperArm))
                      .normalized()
                      .x(),
                  0.9)
            << "the second take is played";
    }
}

TEST(ClipJumps, of_one_frame_that_is_wrong_are_found_too) {
    std::vector<FigureFrame> frames = swaying(3, 120, {0, 90, 0});
    frames[180].turns[kLeftArm].z() += 120;
    const Clip clip = motion_of(frames, 120);
    EXPECT_LT(greatest_speed(clip), 10);
    ASSERT_EQ(clip.notes.size(), 1U);
    EXPECT_NE(clip.notes[0].find(" at 1.50 s and at 1 more places: blended over 0.3"), std::string::npos)
        << clip.notes[0];
}

// What the clip does with the right leg at that time: the way from thigh to foot.
Vec3d right_leg_at(const Clip& clip, double t) {
    const Body& body = test::mannequin();
    const Pose pose = sample(body, clip, t);
    return (joint_at(body, pose, Joint::RightFoot) - joint_at(body, pose, Joint::RightUpperLeg)).normalized();
}

TEST(ClipJumps, of_a_knee_are_found_while_the_arms_are_fast_and_leave_the_other_limbs_alone) {
    constexpr std::size_t kRightLeg = kLeftLeg + 8;
    std::vector<FigureFrame> frames = swaying(2, 60, {0, 90, 0});
    for (std::size_t k = 0; k < frames.size(); ++k)  // 8 m/s at the hand, at all times
        frames[k].turns[kLeftArm].z() = -40 + 50 * std::sin(20 * double(k) / 60);
    const Clip wanted = motion_of(frames, 60);
    frames[10].turns[kRightLeg].x() = -60;  // 0.8 m at the foot, and back
    frames[60].turns[kRightLeg].x() = -60;
    const Clip clip = motion_of(frames, 60);
    ASSERT_EQ(clip.notes.size(), 1U);
    EXPECT_NE(clip.notes[0].find(" at 0.17 s and at 3 more places: blended over 0.3"), std::string::npos)
        << clip.notes[0];
    EXPECT_NEAR(clip.seconds, 2, 1e-3) << "no start is left out for one limb";
    const Body& body = test::mannequin();
    for (const double t : {0.1, 0.16, 0.2, 1.0, 1.1, 1.5}) {
        EXPECT_LT(right_leg_at(clip, t).y(), -0.98) << t;
        EXPECT_LT((joint_at(body, sample(body, clip, t), Joint::LeftHand) -
                   joint_at(body, sample(body, wanted, t), Joint::LeftHand))
                      .norm(),
                  0.01)
            << t;
    }
}

TEST(ClipJumps, by_which_a_joint_only_turns_are_blended) {
    constexpr std::size_t kLeftForeArm = kLeftArm + 1;
    std::vector<FigureFrame> frames = swaying(2, 60, {0, 90, 0});
    for (std::size_t k = 15; k < frames.size(); ++k) frames[k].turns[kLeftForeArm].x() += 170;  // about its own axis
    const Clip clip = motion_of(frames, 60);
    ASSERT_EQ(clip.notes.size(), 1U);
    EXPECT_EQ(clip.notes[0], "a joint turns by 170 degrees in a frame at 0.25 s: blended over 0.30 s");
    EXPECT_NEAR(clip.seconds, 2, 1e-3);
}

// A kick of 15 m/s at the foot.
TEST(ClipJumps, are_none_in_a_fast_motion) {
    for (const double rate : {25.0, 30.0, 60.0, 120.0}) {
        std::vector<FigureFrame> frames = swaying(3, rate, {0, 90, 0});
        for (std::size_t k = 0; k < frames.size(); ++k) {
            const double t = std::clamp((double(k) / rate - 1.5) / 0.25, -1.0, 1.0);
            frames[k].turns[kLeftLeg].x() = -50 * (1 + std::cos(std::numbers::pi * t));
        }
        const Clip clip = motion_of(frames, rate);
        EXPECT_TRUE(clip.notes.empty()) << rate << ' ' << clip.notes.front();
        EXPECT_GT(greatest_speed(clip), 6) << rate;
    }
}

TEST(ClipJumps, are_none_in_what_ships_and_between_keys_that_are_far_apart) {
    for (const std::string& name : motion_names()) EXPECT_TRUE(find_motion(name, test::mannequin()).notes.empty());
    const Body& body = test::mannequin();
    Clip clip{.name = "two keys", .seconds = 1};
    clip.tracks.push_back({.bone = 0, .translation = {{0, 0.4, 1}, {Vec3d(0, 1, 0), Vec3d(0, 1, 3), Vec3d(0, 1, 3)}}});
    EXPECT_TRUE(find_jumps(body, clip).empty());
    clip.tracks[0].translation.times[1] = 0.05;
    ASSERT_EQ(find_jumps(body, clip).size(), 1U);
    EXPECT_NEAR(find_jumps(body, clip)[0].way, 3, 0.5);
}

}  // namespace
}  // namespace selvedge::sim
