// Poses by the angles of joints: read off bodies, turned, put on bodies, and written to files.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "sim/motion/joint_angles.h"
#include "sim/motion/motion_file.h"
#include "tests/sim/motion/support.h"
#include "tests/support/mannequin.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

// The greatest angle between the rotations of a bone in two poses, rad.
double greatest_turn(const Pose& a, const Pose& b) {
    double greatest = 0;
    for (std::size_t i = 0; i < a.bones.size(); ++i)
        greatest = std::max(greatest, a.bones[i].rotation.angularDistance(b.bones[i].rotation));
    return greatest;
}

Vec3d& angles_of(PoseAngles& angles, Joint joint) {
    return angles.joints[std::size_t(joint)];
}

int bone_of(const Body& body, Joint joint) {
    return find_joints(body.bones)[joint];
}

TEST(JointAngles, are_read_back_from_the_rotation_that_they_make) {
    for (std::size_t i = 0; i < kJointCount; ++i) {
        for (const Vec3d& degrees : {Vec3d(40, 20, -70), Vec3d(-100, -60, 10), Vec3d(170, 80, 5), Vec3d(10, 120, 0)}) {
            const Vec3d angles = kDegree * degrees;
            const Vec3d read = joint_angles(Joint(i), joint_rotation(Joint(i), angles), angles + Vec3d(0.1, -0.1, 0.1));
            EXPECT_LT((read - angles).norm(), 1e-9) << joint_name(Joint(i)) << ": " << degrees.transpose();
        }
    }
}

TEST(JointAngles, keep_their_flexion_where_it_and_the_turn_are_about_the_same_axis) {
    const Vec3d straight_out(0.3, std::numbers::pi / 2, 0.4);
    const Eigen::Quaterniond rotation = joint_rotation(Joint::LeftUpperArm, straight_out);
    EXPECT_LT((joint_angles(Joint::LeftUpperArm, rotation, straight_out) - straight_out).norm(), 1e-6);
}

TEST(JointAngles, of_a_body_give_its_pose_again) {
    const Body& body = test::mannequin();
    EXPECT_LT(greatest_turn(pose_of(pose_angles(body, rest_pose(body)), body), rest_pose(body)), 1e-6);
    for (const char* name : {"A", "T", "stride", "sit"}) {
        const Pose pose = find_pose(name, body);
        EXPECT_LT(greatest_turn(pose_of(pose_angles(body, pose), body), pose), 1e-6) << name;
    }
    PoseAngles angles = pose_angles(body, find_pose("T", body));
    EXPECT_NEAR(angles_of(angles, Joint::LeftUpperArm)[1], 86 * kDegree, 1e-6) << "as in its file";
}

TEST(JointAngles, turn_one_joint_and_leave_the_others) {
    const Body& body = test::mannequin();
    const Pose before = find_pose("A", body);
    PoseAngles angles = pose_angles(body, before);
    angles_of(angles, Joint::LeftLowerArm)[0] += 60 * kDegree;
    const Pose after = pose_of(angles, body);
    for (std::size_t i = 0; i < body.bones.size(); ++i) {
        const double turn = before.bones[i].rotation.angularDistance(after.bones[i].rotation);
        EXPECT_NEAR(turn, int(i) == bone_of(body, Joint::LeftLowerArm) ? 60 * kDegree : 0, 1e-6) << body.bones[i].name;
    }
    EXPECT_GT(joint_at(body, after, Joint::LeftHand).z(), joint_at(body, before, Joint::LeftHand).z() + 0.1)
        << "an elbow bends forward";
}

TEST(JointAngles, count_about_axes_that_go_along_with_the_joint_above) {
    const Body& body = test::mannequin();
    PoseAngles angles = pose_angles(body, rest_pose(body));
    angles_of(angles, Joint::Chest)[2] = 50 * kDegree;  // to the left
    const Pose pose = pose_of(angles, body);
    const int bone = bone_of(body, Joint::Neck);
    const Vec3d front = axes_of_angles(body, pose, angles, bone) * Vec3d::UnitZ();
    const Eigen::Matrix3d rest = bone_frames(body, rest_pose(body))[std::size_t(bone_of(body, Joint::Chest))].linear();
    const Eigen::Matrix3d now = bone_frames(body, pose)[std::size_t(bone_of(body, Joint::Chest))].linear();
    EXPECT_LT((front - now * rest.transpose() * Vec3d::UnitZ()).norm(), 1e-6);
    EXPECT_GT(front.x(), 0.7);
}

// The mannequin with a bone of no name that is known: that of one hand.
Body with_an_odd_bone() {
    Body body = test::mannequin();
    body.bones[std::size_t(bone_of(body, Joint::LeftHand))].name = "claw";
    return body;
}

TEST(JointAngles, of_other_bones_are_about_the_axes_of_the_rest_pose) {
    const Body body = with_an_odd_bone();
    const int claw = find_bone(body, "claw");
    PoseAngles angles = pose_angles(body, rest_pose(body));
    EXPECT_TRUE(angles.bones.empty()) << "nothing is turned";
    angles.bones[claw] = Vec3d(0, 0, 0.5);
    const Pose turned = pose_of(angles, body);
    const auto bone = std::size_t(claw);
    const Eigen::Matrix3d now = bone_frames(body, turned)[bone].linear();
    const Eigen::Matrix3d rest = bone_frames(body, rest_pose(body))[bone].linear();
    EXPECT_LT((now * rest.transpose() - Eigen::AngleAxisd(0.5, Vec3d::UnitY()).toRotationMatrix()).norm(), 1e-6);
    EXPECT_LT((pose_angles(body, turned).bones.at(claw) - Vec3d(0, 0, 0.5)).norm(), 1e-6);
}

TEST(JointAngles, turn_bones_of_a_body_of_which_no_joint_is_known) {
    Body body = test::mannequin();
    for (std::size_t i = 0; i < body.bones.size(); ++i) body.bones[i].name = "strange " + std::to_string(i);
    PoseAngles angles = pose_angles(body, rest_pose(body));
    EXPECT_EQ(angles, PoseAngles());
    angles.bones[3] = Vec3d(0.2, 0, 0);
    EXPECT_NEAR(greatest_turn(pose_of(angles, body), rest_pose(body)), 0.2, 1e-9);
}

TEST(JointAngles, are_written_as_a_file_that_is_the_same_pose) {
    const Body& body = test::mannequin();
    PoseAngles angles = pose_angles(body, find_pose("stride", body));
    angles_of(angles, Joint::RightLowerArm) = Vec3d(70, 0, -20) * kDegree;
    angles_of(angles, Joint::Head) = Vec3d(10, 5, 30) * kDegree;
    const std::string text = write_pose(angles, "wave");
    EXPECT_EQ(parse_motion(text, "wave.json").clips.front().name, "wave");
    const TemporaryFolder folder;
    const std::string file = (folder / "wave.json").string();
    std::ofstream(file) << text;
    EXPECT_LT(greatest_turn(find_pose(file, body), pose_of(angles, body)), 0.001 * kDegree);
}

}  // namespace
}  // namespace selvedge::sim
