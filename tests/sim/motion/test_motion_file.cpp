#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "sim/body/joint_names.h"
#include "sim/body/skin.h"
#include "sim/core/error.h"
#include "sim/motion/grounding.h"
#include "sim/motion/motion_file.h"
#include "tests/sim/motion/bvh_figure.h"
#include "tests/sim/motion/support.h"
#include "tests/support/mannequin.h"
#include "tests/support/parted_body.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

Vec3d direction(const Body& body, const Pose& pose, Joint from, Joint to) {
    return (joint_at(body, pose, to) - joint_at(body, pose, from)).normalized();
}

// Angle of a knee or elbow, rad; positive where it bends as they do.
double bend(const Body& body, const Pose& pose, Joint upper) {
    const Joint lower = Joint(int(upper) + 1), end = Joint(int(upper) + 2);
    const Vec3d a = direction(body, pose, upper, lower), b = direction(body, pose, lower, end);
    const auto bone = std::size_t(find_joints(body.bones)[upper]);
    const Eigen::Matrix3d turn =
        bone_frames(body, pose)[bone].linear() * bone_frames(body, rest_pose(body))[bone].linear().transpose();
    const bool is_arm = upper == Joint::LeftUpperArm || upper == Joint::RightUpperArm;
    return (is_arm ? -1 : 1) * std::atan2(a.cross(b).dot(turn * Vec3d::UnitX()), a.dot(b));
}

std::string message_of(const std::string& text) {
    try {
        parse_motion(text, "m.json");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(ShippedMotions, are_listed_and_fit_the_mannequin) {
    EXPECT_EQ(motion_names(), (std::vector<std::string>{"arms_down", "arms_up", "sit", "turn", "walk"}));
    EXPECT_EQ(pose_names(), (std::vector<std::string>{"A", "T", "stride"}));
    const Body& body = test::mannequin();
    for (const std::string& name : motion_names()) {
        const Clip clip = find_motion(name, body);
        EXPECT_EQ(clip.name, name);
        EXPECT_GT(clip.seconds, 1);
        EXPECT_NEAR(lowest_point(body, clip), 0, 2e-4) << name;
        for (double t = 0; t <= clip.seconds; t += 0.05) {
            const Pose pose = sample(body, clip, t);
            for (const Joint joint : {Joint::LeftUpperLeg, Joint::RightUpperLeg}) {
                EXPECT_GT(bend(body, pose, joint), -1e-6) << name << " at " << t;
                EXPECT_LT(bend(body, pose, joint), 2) << name << " at " << t;
            }
            EXPECT_LT(lowest_point(body, pose), 0.02) << name << " at " << t;
        }
    }
}

TEST(ShippedMotions, move_smoothly) {
    const Body& body = test::mannequin();
    for (const std::string& name : motion_names()) {
        const Clip clip = find_motion(name, body);
        std::vector<Vec3f> before, x;
        const SkinnedSurface surface(body);
        constexpr double kStep = 1.0 / 60;
        const int frames = int((clip.is_loop ? 2 : 1) * clip.seconds / kStep);
        for (int i = 0; i <= frames; ++i) {
            surface.positions(body, sample(body, clip, i * kStep), x);
            float farthest = 0;
            for (std::size_t v = 0; v < before.size(); ++v) farthest = std::max(farthest, (x[v] - before[v]).norm());
            EXPECT_LT(farthest, 0.08F) << name << " at " << i * kStep;  // 5 m/s
            before = x;
        }
    }
}

TEST(ShippedMotions, end_in_the_poses_of_their_names) {
    const Body& body = test::mannequin();
    const Pose sit = find_pose("sit", body), up = find_pose("arms_up", body), down = find_pose("arms_down", body);
    const Pose t = find_pose("T", body);
    for (const Joint side : {Joint::LeftUpperLeg, Joint::RightUpperLeg}) {
        const Joint knee = Joint(int(side) + 1), foot = Joint(int(side) + 2);
        EXPECT_LT(std::abs(direction(body, sit, side, knee).y()), 0.05);  // thighs level
        EXPECT_GT(direction(body, sit, side, knee).z(), 0.95);
        EXPECT_LT(direction(body, sit, knee, foot).y(), -0.99);
    }
    for (const Joint side : {Joint::LeftUpperArm, Joint::RightUpperArm}) {
        const Joint hand = Joint(int(side) + 2);
        EXPECT_GT(direction(body, up, side, hand).y(), 0.9);
        EXPECT_LT(direction(body, down, side, hand).y(), -0.95);
        EXPECT_GT(std::abs(direction(body, t, side, hand).x()), 0.99);
        EXPECT_GT(bend(body, sit, side), 0.5);
    }
    EXPECT_NEAR(lowest_point(body, sit), 0, 1e-5);
    const Pose stride = find_pose("stride", body);
    EXPECT_GT(joint_at(body, stride, Joint::LeftFoot).z() - joint_at(body, stride, Joint::RightFoot).z(), 0.5);
}

TEST(ShippedMotions, walk_without_sliding_on_a_foot_that_stands) {
    const Body& body = test::mannequin();
    const Clip walk = find_motion("walk", body);
    ASSERT_TRUE(walk.is_loop);
    EXPECT_NEAR(walk.travel.z(), 1.16, 0.15);  // m, a slow step of a person of 1.65 m
    // The left foot is flat from 0.10 to 0.34 of the cycle, the right one half a cycle later.
    for (const auto& [foot, start] : {std::pair(Joint::LeftFoot, 0.10), std::pair(Joint::RightFoot, 0.60)}) {
        const Vec3d at = joint_at(body, sample(body, walk, start * walk.seconds), foot);
        for (double share = 0; share <= 0.24; share += 0.02) {
            const Vec3d now = joint_at(body, sample(body, walk, (start + share) * walk.seconds), foot);
            EXPECT_LT((now - at).norm(), 0.015) << share;
        }
    }
    const Vec3d later = joint_at(body, sample(body, walk, 1.25 * walk.seconds), Joint::Head);
    const Vec3d now = joint_at(body, sample(body, walk, 0.25 * walk.seconds), Joint::Head);
    EXPECT_LT((later - now - walk.travel).norm(), 1e-6);
}

TEST(ShippedMotions, turn_once_round_on_the_spot) {
    const Body& body = test::mannequin();
    const Clip turn = find_motion("turn", body);
    const auto heading = [&](double t) {
        const Pose pose = sample(body, turn, t);
        const Vec3d left = joint_at(body, pose, Joint::LeftUpperLeg) - joint_at(body, pose, Joint::RightUpperLeg);
        return std::atan2(-left.z(), left.x());
    };
    double sum = 0;
    for (double t = 0; t < turn.seconds; t += 0.05)
        sum += std::remainder(heading(std::min(t + 0.05, turn.seconds)) - heading(t), 2 * M_PI);
    EXPECT_NEAR(sum, 2 * M_PI, 0.01);
    const Vec3d rest = joint_at(body, rest_pose(body), Joint::Hips);
    for (double t = 0; t < turn.seconds; t += 0.1) {
        const Vec3d way = joint_at(body, sample(body, turn, t), Joint::Hips) - rest;
        EXPECT_LT(std::hypot(way.x(), way.z()), 0.06);
    }
}

TEST(ShippedMotions, fit_a_body_whose_bones_have_other_names_and_axes) {
    Body body = shapes::in_parts(test::mannequin(), shapes::Joints::Gaps);
    const std::vector<Eigen::Affine3d> frames = bone_frames(body, rest_pose(body));
    for (std::size_t i = 0; i < body.bones.size(); ++i) {
        Bone& bone = body.bones[i];
        const Eigen::Affine3d own = frames[i] * Eigen::AngleAxisd(0.3 * double(i), Vec3d(1, 2, 3).normalized());
        const auto parent = std::size_t(std::max(0, bone.parent));
        const Eigen::Affine3d above =
            bone.parent < 0 ? Eigen::Affine3d::Identity()
                            : frames[parent] * Eigen::AngleAxisd(0.3 * double(parent), Vec3d(1, 2, 3).normalized());
        const Eigen::Affine3d local = above.inverse() * own;
        bone.rest.rotation = Eigen::Quaterniond(local.rotation());
        bone.rest.translation = local.translation();
        bone.inverse_bind = own.inverse();
    }
    const Pose sit = find_pose("sit", body);
    EXPECT_NEAR(lowest_point(body, sit), 0, 1e-5);
    EXPECT_LT(std::abs(direction(body, sit, Joint::LeftUpperLeg, Joint::LeftLowerLeg).y()), 0.05);
    EXPECT_GT(direction(body, find_pose("T", body), Joint::LeftUpperArm, Joint::LeftHand).x(), 0.98);
    const Clip walk = find_motion("walk", body);
    for (const double share : {0.2, 0.6}) {
        const Pose pose = sample(body, walk, share * walk.seconds);
        EXPECT_GT(bend(body, pose, Joint::LeftUpperLeg), -0.1) << share;
        EXPECT_GT(bend(body, pose, Joint::RightUpperLeg), -0.1) << share;
    }
}

TEST(ShippedMotions, fit_bodies_from_files) {
    const char* data = std::getenv("SELVEDGE_TEST_DATA");
    if (!data) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set";
    for (const char* file : {"mh_female_cmu01_01.glb", "CesiumMan.glb"}) {
        const Body body = load_body(std::filesystem::path(data) / "bodies" / file);
        const Pose sit = find_pose("sit", body);
        EXPECT_NEAR(lowest_point(body, sit), 0, 1e-5) << file;
        EXPECT_LT(std::abs(direction(body, sit, Joint::LeftUpperLeg, Joint::LeftLowerLeg).y()), 0.05) << file;
        EXPECT_GT(direction(body, find_pose("T", body), Joint::LeftUpperArm, Joint::LeftHand).x(), 0.98) << file;
    }
}

TEST(FindMotion, reads_files_of_motions_and_says_what_is_known) {
    const Body& body = test::mannequin();
    const TemporaryFolder folder;
    const std::string path = (folder / "nod.json").string();
    std::ofstream(path) << R"({"name": "nod", "times": [0, 1], "joints": {"head": {"flex": [0, 20]}}})";
    const Clip nod = find_motion(path, body);
    EXPECT_EQ(nod.name, "nod");
    const Vec3d up = bone_frames(body, sample(body, nod, 1))[std::size_t(find_bone(body, "head"))].linear().col(1);
    EXPECT_NEAR(std::atan2(up.z(), up.y()), 20 * M_PI / 180, 1e-6);
    try {
        find_motion("gallop", body);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(
            error.what(),
            "no motion 'gallop': known are A, T, arms_down, arms_up, sit, stride, turn, walk, or name a .json, "
            ".bvh, .fbx, .gltf or .glb file");
    }
    EXPECT_THROW(find_motion("not_there.bvh", body), InputError);
    EXPECT_THROW(find_pose("not_there.json", body), InputError);
}

TEST(MotionFile, angles_follow_a_smooth_course_without_overshoot) {
    const BodyClips motion = parse_motion(
        R"({"name": "m", "times": [0, 1, 2], "joints": {"left_upper_arm": {"spread": [0, 90, 90]}}})", "m");
    double before = 0;
    for (double t = 0; t <= 2; t += 0.05) {
        const Pose pose = sample(motion.body, motion.clips.front(), t);
        const Vec3d down = bone_frames(motion.body, pose)[std::size_t(Joint::LeftUpperArm)].linear() * -Vec3d::UnitY();
        const double angle = std::atan2(down.x(), -down.y());
        EXPECT_GE(angle, before - 1e-9);
        EXPECT_LE(angle, M_PI / 2 + 1e-9);
        EXPECT_LT(angle - before, 0.125);  // 1.5 times the mean slope
        before = angle;
    }
    EXPECT_NEAR(before, M_PI / 2, 1e-9);
}

TEST(MotionFile, notes_opened_arms_and_still_joints_when_it_fits_a_motion_to_a_body) {
    const TemporaryFolder folder;
    std::vector<FigureJoint> joints = figure_in_t_pose();
    const auto notes_of = [&](double arms) {
        std::vector<FigureFrame> frames(10, standing_frame(joints, {0, 90, 0}));
        for (FigureFrame& frame : frames)
            for (std::size_t i = 0; i < joints.size(); ++i)
                if (joints[i].name == "LeftArm" || joints[i].name == "RightArm")
                    frame.turns[i].z() = joints[i].name == "LeftArm" ? -arms : arms;
        return find_motion(write_bvh(folder / "m.bvh", joints, frames, 30).string(), test::mannequin()).notes;
    };
    EXPECT_TRUE(notes_of(45).empty());
    const std::vector<std::string> crossed = notes_of(100);  // hands in the thighs
    ASSERT_EQ(crossed.size(), 1U);
    EXPECT_TRUE(crossed[0].starts_with("arms opened by ")) << crossed[0];
    EXPECT_TRUE(crossed[0].ends_with(" degrees, which would be in trunk or thighs")) << crossed[0];
    for (FigureJoint& joint : joints) {
        if (joint.name == "LeftForeArm") joint.name = "Bone_7";
        if (joint.name == "LeftUpLeg" || joint.name == "RightFoot") joint.name += "_unknown_name";
    }
    const std::vector<std::string> unknown = notes_of(45);
    ASSERT_EQ(unknown.size(), 2U);
    EXPECT_EQ(unknown[0],
              "the motion's skeleton has no joint that is known as left_lower_arm, left_lower_leg: not moved");
    EXPECT_EQ(unknown[1], "the motion's skeleton has no hips with a whole leg: the body stays in its place");
}

TEST(MotionFile, of_several_motions_that_nobody_chose_is_the_first_that_moves) {
    const auto clip = [](const std::string& name, double y) {
        return Clip{.name = name,
                    .seconds = 1,
                    .tracks = {{.bone = 0, .translation = {{0, 1}, {Vec3d(0, 1, 0), Vec3d(0, y, 0)}}}}};
    };
    const std::vector<Clip> clips{clip("T-pose", 1), clip("walk", 2), clip("run", 3)};
    EXPECT_EQ(find_clip(clips, "", "m.glb").name, "walk");
    EXPECT_EQ(find_clip(clips, "0", "m.glb").name, "T-pose");
    EXPECT_EQ(find_clip({clips[0]}, "", "m.glb").name, "T-pose");
    EXPECT_EQ(choice_text(clips), "the file has 3 motions: 'walk' is played, and not 'T-pose', 'run'");
    EXPECT_EQ(choice_text({clip("take", 1), clip("take", 2)}),
              "the file has 2 motions: 'take' is played, and not 'take'");
}

TEST(MotionFile, with_a_fault_is_refused_by_its_place) {
    const auto with = [](const std::string& rest) { return R"({"name": "m", )" + rest + "}"; };
    const std::string joints = R"("joints": {"head": {"flex": [0, 1]}})";
    EXPECT_EQ(message_of(with(R"("times": [0, 1], )" + joints)), "");
    EXPECT_EQ(message_of(with(R"("times": [], )" + joints)), "m.json: times: empty: at least the time 0 is needed");
    EXPECT_EQ(message_of(with(R"("times": [0, 0], )" + joints)),
              "m.json: times[1]: it must be 1 ms or more after the time before it");
    EXPECT_EQ(message_of(with(R"("times": [0, 1, 0.5], )" + joints)),
              "m.json: times[2]: it must be 1 ms or more after the time before it");
    EXPECT_EQ(message_of(with(R"("times": [0.5, 1], )" + joints)), "m.json: times[0]: the first time must be 0");
    EXPECT_EQ(message_of(with(R"("times": [0, -1], )" + joints)), "m.json: times[1]: -1 is not between 0 and 600");
    EXPECT_EQ(message_of(with(R"("times": [0, 601], )" + joints)), "m.json: times[1]: 601 is not between 0 and 600");
    EXPECT_NE(message_of(with(R"("times": [0, NaN], )" + joints)), "");
    EXPECT_NE(message_of(with(R"("times": [0, 1e999], )" + joints)), "");
    EXPECT_EQ(message_of(with(R"("times": [0, 1, 2], )" + joints)),
              "m.json: joints.head.flex: 2 values where 3 times are");
    EXPECT_EQ(message_of(with(R"("times": [0, 1], "joints": {"head": {"flex": [0, 9999]}})")),
              "m.json: joints.head.flex[1]: 9999 is not between -7200 and 7200");
    EXPECT_EQ(message_of(with(R"("times": [0, 1], "joints": {"head": {"spread": 3}})")),
              "m.json: joints.head.spread: no such key; known are flex, lean, turn");
    EXPECT_EQ(message_of(with(R"("times": [0, 1], "speed": 2, )" + joints)),
              "m.json: speed: no such key; known are name, title, note, loop, times, hips, joints");
    EXPECT_TRUE(message_of(with(R"("times": [0, 1], "joints": {"tail": {"flex": 3}})"))
                    .starts_with("m.json: joints.tail: no such joint; known are hips, spine, "));
    EXPECT_EQ(message_of(with(R"("times": [0, 1], "loop": true, )" + joints)),
              "m.json: joints.head.flex: a loop must end as it starts");
    EXPECT_EQ(message_of(with(R"("times": [0, 1], "loop": true, "joints": {}, "hips": {"up": [0, 1]})")),
              "m.json: hips.up: a loop must end as it starts");
    EXPECT_EQ(message_of(with(R"("times": [0], "loop": true, "joints": {})")),
              "m.json: times: a loop needs at least two times");
    EXPECT_NE(message_of(with(R"("times": [0, 1])")), "");
    EXPECT_NE(message_of(R"({"times": [0, 1], "joints": {}})"), "");
    EXPECT_NE(message_of("[]"), "");
    std::string times = "0";
    for (int k = 1; k <= 10'000; ++k) times += "," + std::to_string(k * 0.05);
    EXPECT_EQ(message_of(with(R"("times": [)" + times + R"(], "joints": {})")), "m.json: times: more than 10000 times");
}

}  // namespace
}  // namespace selvedge::sim
