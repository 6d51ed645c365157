#include <gtest/gtest.h>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "sim/core/error.h"
#include "sim/motion/motion_file.h"
#include "sim/motion/standing_rest.h"
#include "sim/repair/load_body.h"
#include "tests/sim/motion/bvh_figure.h"
#include "tests/sim/motion/support.h"
#include "tests/support/mannequin.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

Vec3d way(const Body& body, const Pose& pose, Joint from, Joint to) {
    return (joint_at(body, pose, to) - joint_at(body, pose, from)).normalized();
}

// Stands still for a second, and raises its left arm to the side. `swing`: turns the left upper arm, degrees.
std::vector<FigureFrame> arm_raised(const std::vector<FigureJoint>& joints, std::size_t arm, const Vec3d& swing,
                                    int frames, const Vec3d& place = {0, 90, 0}) {
    std::vector<FigureFrame> motion;
    for (int k = 0; k <= frames; ++k) {
        FigureFrame frame = standing_frame(joints, place);
        frame.turns[arm] += swing * k / frames;
        motion.push_back(frame);
    }
    return motion;
}

std::size_t index_of(const std::vector<FigureJoint>& joints, const std::string& name) {
    const auto found = std::ranges::find(joints, name, &FigureJoint::name);
    return static_cast<std::size_t>(found - joints.begin());
}

// Upright, facing the front, with hanging legs; the left arm hangs, and then points to the left.
void expect_raises_left_arm(const Body& body, const Clip& clip) {
    for (const double share : {0.0, 0.5, 1.0}) {
        const Pose pose = sample(body, clip, share * clip.seconds);
        EXPECT_GT(way(body, pose, Joint::Hips, Joint::Head).y(), 0.98) << share;
        EXPECT_LT(way(body, pose, Joint::LeftUpperLeg, Joint::LeftFoot).y(), -0.98) << share;
        EXPECT_LT(way(body, pose, Joint::RightUpperArm, Joint::RightHand).y(), -0.9) << share;
        EXPECT_GT(way(body, pose, Joint::RightUpperLeg, Joint::LeftUpperLeg).x(), 0.98) << share;
        EXPECT_GT(way(body, pose, Joint::LeftFoot, Joint::LeftToe).z(), 0.6) << share;
    }
    const Pose first = sample(body, clip, 0), last = sample(body, clip, clip.seconds);
    EXPECT_LT(way(body, first, Joint::LeftUpperArm, Joint::LeftHand).y(), -0.9);
    EXPECT_GT(way(body, last, Joint::LeftUpperArm, Joint::LeftHand).x(), 0.95);
}

TEST(StandingRest, of_bones_that_all_lie_along_x_is_taken_from_the_motion) {
    const TemporaryFolder folder;
    const std::vector<FigureJoint> joints = figure_along_x();
    const auto path = write_bvh(folder / "along_x.bvh", joints,
                                arm_raised(joints, index_of(joints, "UpperArm_L"), {0, 0, 90}, 30, {0, 0, 0}), 30);
    const Clip clip = find_motion(path.string(), test::mannequin());
    expect_raises_left_arm(test::mannequin(), clip);
    ASSERT_EQ(clip.notes.size(), 1U);
    EXPECT_EQ(clip.notes[0], "the rest pose of the motion's skeleton does not stand: taken from the motion, at 0.00 s");
}

TEST(StandingRest, that_stands_is_left_as_it_is) {
    const TemporaryFolder folder;
    const std::vector<FigureJoint> joints = figure_in_t_pose();
    const auto path =
        write_bvh(folder / "t.bvh", joints, arm_raised(joints, index_of(joints, "LeftArm"), {0, 0, 80}, 30), 30);
    const Clip clip = find_motion(path.string(), test::mannequin());
    expect_raises_left_arm(test::mannequin(), clip);
    EXPECT_TRUE(clip.notes.empty()) << clip.notes.front();
}

TEST(StandingRest, along_another_axis_than_the_motion_is_turned_with_it) {
    const TemporaryFolder folder;
    const std::vector<FigureJoint> joints = figure_in_t_pose();
    std::vector<FigureFrame> frames = arm_raised(joints, index_of(joints, "LeftArm"), {0, 0, 80}, 30, {3, 5, 90});
    for (FigureFrame& frame : frames) frame.turns[0] = {90, 0, 0};  // stands along z, and faces -y
    const auto path = write_bvh(folder / "z_up.bvh", joints, frames, 30);
    const Clip clip = find_motion(path.string(), test::mannequin());
    expect_raises_left_arm(test::mannequin(), clip);
    ASSERT_EQ(clip.notes.size(), 1U);
    EXPECT_EQ(clip.notes[0],
              "the rest pose of the motion's skeleton stands along y, the motion along z: turned upright");
}

TEST(StandingRest, of_someone_who_lies_throughout_is_trusted) {
    const TemporaryFolder folder;
    const std::vector<FigureJoint> joints = figure_in_t_pose();
    std::vector<FigureFrame> frames;
    for (int k = 0; k <= 60; ++k) {
        frames.push_back(standing_frame(joints, {0, 10, 0}));
        frames.back().turns[0] = {0, 0, 6.0 * k};  // rolls over head and feet once
    }
    const auto path = write_bvh(folder / "rolls.bvh", joints, frames, 30);
    const Clip clip = find_motion(path.string(), test::mannequin());
    EXPECT_TRUE(clip.notes.empty());
    EXPECT_LT(way(test::mannequin(), sample(test::mannequin(), clip, 1), Joint::Hips, Joint::Head).y(), -0.98);
}

TEST(StandingRest, is_the_same_in_any_unit_and_at_any_rate) {
    const TemporaryFolder folder;
    for (const auto& joints : {figure_along_x(), figure_in_t_pose()}) {
        const bool is_t = joints.front().name == "Hips";
        const std::size_t arm = index_of(joints, is_t ? "LeftArm" : "UpperArm_L");
        for (const double unit : {0.01, 1.0, 10.0, 1 / 2.54, 1 / 5.6444}) {
            for (const int rate : {10, 30, 120, 240}) {
                const auto frames = arm_raised(joints, arm, {0, 0, is_t ? 80.0 : 90.0}, rate, {7, is_t ? 90.0 : 0, 4});
                const auto path = write_bvh(folder / "any.bvh", joints, frames, rate, unit);
                const Clip clip = find_motion(path.string(), test::mannequin());
                EXPECT_NEAR(clip.seconds, 1, 1e-3) << unit << ' ' << rate;
                expect_raises_left_arm(test::mannequin(), clip);
                EXPECT_EQ(clip.notes.size(), is_t ? 0U : 1U) << unit << ' ' << rate;
            }
        }
    }
}

// Stands straight along z, which is up, and hops on the spot or climbs 60 cm.
TEST(StandingRest, of_someone_who_hops_or_climbs_is_turned_upright) {
    const TemporaryFolder folder;
    for (const bool hops : {true, false}) {
        for (const auto& joints : {figure_along_x(), figure_in_t_pose()}) {
            const bool is_t = joints.front().name == "Hips";
            std::vector<FigureFrame> frames;
            for (int k = 0; k <= 60; ++k) {
                const double way = hops ? 40 * std::abs(std::sin(std::numbers::pi * k / 20)) : k;  // cm
                frames.push_back(standing_frame(joints, {hops ? 0.0 : way, 0, (is_t ? 90 : 0) + way}));
                frames.back().turns[0] = {90, 0, 0};
            }
            const auto path = write_bvh(folder / "rises.bvh", joints, frames, 30);
            const Clip clip = find_motion(path.string(), test::mannequin());
            ASSERT_EQ(clip.notes.size(), 1U) << hops << is_t;
            EXPECT_EQ(clip.notes[0].ends_with("turned upright"), is_t) << clip.notes[0];
            for (const double share : {0.0, 0.3, 1.0}) {
                const Pose pose = sample(test::mannequin(), clip, share * clip.seconds);
                EXPECT_GT(way(test::mannequin(), pose, Joint::Hips, Joint::Head).y(), 0.98) << hops << is_t;
                EXPECT_LT(way(test::mannequin(), pose, Joint::LeftUpperLeg, Joint::LeftFoot).y(), -0.98);
            }
        }
    }
}

// On hands and knees along z: a trunk that is level, thighs that are upright, shins on the floor.
std::vector<FigureFrame> crawling(const std::vector<FigureJoint>& joints) {
    std::vector<FigureFrame> frames;
    for (int k = 0; k <= 60; ++k) {
        const double swing = 20 * std::sin(k / 6.0);
        frames.push_back(standing_frame(joints, {0, 45, 2.0 * k}));
        std::vector<Vec3d>& turns = frames.back().turns;
        turns[0] = {90, 0, 0};
        for (const auto& [side, sign] : {std::pair{"Left", 1.0}, std::pair{"Right", -1.0}}) {
            turns[index_of(joints, side + std::string("UpLeg"))] = {-90 + sign * swing, 0, 0};
            turns[index_of(joints, side + std::string("Leg"))] = {90 - sign * swing, 0, 0};
        }
    }
    return frames;
}

TEST(StandingRest, of_someone_who_crawls_is_not_taken_for_one_of_other_axes) {
    const TemporaryFolder folder;
    const std::vector<FigureJoint> joints = figure_in_t_pose();
    const auto path = write_bvh(folder / "crawls.bvh", joints, crawling(joints), 30);
    const Clip clip = find_motion(path.string(), test::mannequin());
    for (const std::string& note : clip.notes) EXPECT_EQ(note.find("turned upright"), std::string::npos) << note;
    for (const double share : {0.0, 0.5, 1.0}) {
        const Pose pose = sample(test::mannequin(), clip, share * clip.seconds);
        EXPECT_GT(way(test::mannequin(), pose, Joint::Hips, Joint::Neck).z(), 0.95) << share;
        EXPECT_LT(way(test::mannequin(), pose, Joint::LeftUpperLeg, Joint::LeftLowerLeg).y(), -0.9) << share;
    }
}

TEST(StandingRest, of_someone_who_lies_straight_is_trusted_in_formats_that_have_y_up) {
    const TemporaryFolder folder;
    const std::vector<FigureJoint> joints = figure_in_t_pose();
    std::vector<FigureFrame> frames(31, standing_frame(joints, {0, 10, 0}));
    for (FigureFrame& frame : frames) frame.turns[0] = {-90, 0, 0};
    const auto path = write_bvh(folder / "lies.bvh", joints, frames, 30);
    BodyClips trusted = load_motion(path), guessed = load_motion(path);
    EXPECT_FALSE(trusted.is_y_up) << "BVH does not say";
    stand_up(trusted.body, trusted.clips[0], {.is_y_up = true});
    EXPECT_TRUE(trusted.clips[0].notes.empty()) << trusted.clips[0].notes[0];
    stand_up(guessed.body, guessed.clips[0]);
    EXPECT_EQ(guessed.clips[0].notes.size(), 1U) << "a format without axes: who stands straight along z is upright";
}

TEST(StandingRest, taken_from_someone_who_leans_has_an_upright_trunk) {
    const TemporaryFolder folder;
    const std::vector<FigureJoint> joints = figure_along_x();
    std::vector<FigureFrame> frames = arm_raised(joints, index_of(joints, "UpperArm_L"), {0, 0, 20}, 30, {0, 0, 0});
    for (FigureFrame& frame : frames) frame.turns[index_of(joints, "Spine")] = {0, -40, 0};  // leans forward throughout
    const auto path = write_bvh(folder / "leans.bvh", joints, frames, 30);
    const Clip clip = find_motion(path.string(), test::mannequin());
    ASSERT_FALSE(clip.notes.empty());
    EXPECT_TRUE(clip.notes[0].ends_with(", with its trunk straightened")) << clip.notes[0];
    const Vec3d trunk = way(test::mannequin(), sample(test::mannequin(), clip, 0.5), Joint::Hips, Joint::Neck);
    EXPECT_NEAR(std::atan2(trunk.z(), trunk.y()) * 180 / std::numbers::pi, 28, 5)
        << "15 cm upright, and 35 cm that lean by 40 degrees";
    EXPECT_LT(way(test::mannequin(), sample(test::mannequin(), clip, 0.5), Joint::LeftUpperLeg, Joint::LeftFoot).y(),
              -0.98);
}

TEST(StandingRest, taken_from_someone_who_leans_from_the_hips_and_looks_ahead_has_a_level_head) {
    const TemporaryFolder folder;
    const std::vector<FigureJoint> joints = figure_along_x();
    std::vector<FigureFrame> frames = arm_raised(joints, index_of(joints, "UpperArm_L"), {0, 0, 20}, 30, {0, 0, 0});
    for (FigureFrame& frame : frames) {
        frame.turns[index_of(joints, "Hips")] = {0, -40, 90};
        frame.turns[index_of(joints, "Neck")] = {0, 40, 0};
        for (const char* leg : {"UpperLeg_L", "UpperLeg_R"}) frame.turns[index_of(joints, leg)] = {0, -40, 180};
    }
    const auto path = write_bvh(folder / "looks_ahead.bvh", joints, frames, 30);
    const Body& body = test::mannequin();
    const Clip clip = find_motion(path.string(), body);
    ASSERT_FALSE(clip.notes.empty());
    EXPECT_TRUE(clip.notes[0].ends_with(", with its trunk straightened")) << clip.notes[0];
    const Pose pose = sample(body, clip, 0.5);
    EXPECT_GT(way(body, pose, Joint::Neck, Joint::Head).dot(way(body, rest_pose(body), Joint::Neck, Joint::Head)),
              0.995);
    EXPECT_GT(way(body, pose, Joint::Hips, Joint::Neck).z(), 0.5);
    EXPECT_LT(way(body, pose, Joint::LeftUpperLeg, Joint::LeftFoot).y(), -0.98);
}

std::string problem_of(const std::filesystem::path& path) {
    try {
        find_motion(path.string(), test::mannequin());
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(StandingRest, is_refused_where_no_moment_stands) {
    const TemporaryFolder folder;
    const std::vector<FigureJoint> joints = figure_along_x();
    std::vector<FigureFrame> frames(3, standing_frame(joints, {0, 0, 0}));
    for (FigureFrame& frame : frames) {  // its feet are above its head
        frame.turns[index_of(joints, "UpperLeg_L")] = {0, 0, 0};
        frame.turns[index_of(joints, "UpperLeg_R")] = {0, 0, 0};
    }
    const std::string folded = problem_of(write_bvh(folder / "folded.bvh", joints, frames, 30));
    EXPECT_NE(folded.find("folded.bvh: clip 'Motion': its legs point upward beside a trunk that is upright"),
              std::string::npos)
        << folded;
    for (FigureFrame& frame : frames) frame.turns[index_of(joints, "Chest")] = {0, 0, 120};
    const std::string bent = problem_of(write_bvh(folder / "bent.bvh", joints, frames, 30));
    EXPECT_NE(bent.find("bent.bvh: clip 'Motion': neither its rest pose nor any moment of it stands"),
              std::string::npos)
        << bent;
}

}  // namespace
}  // namespace selvedge::sim
