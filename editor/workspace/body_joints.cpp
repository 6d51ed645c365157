#include "editor/workspace/body_joints.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

namespace selvedge::editor {
namespace {

constexpr std::array<const char*, sim::kMiddleJoints> kMiddle{"Hips", "Waist", "Chest", "Neck", "Head"};
constexpr std::array<const char*, sim::kSideJoints> kSide{"collarbone", "shoulder", "elbow", "wrist",
                                                          "hip",        "knee",     "ankle", "toes"};

// The joint on the left side, or in the middle.
sim::Joint left_of(sim::Joint joint) {
    return static_cast<std::size_t>(joint) < sim::kMiddleJoints + sim::kSideJoints ? joint : mirrored(joint);
}

}  // namespace

std::string joint_title(sim::Joint joint) {
    const auto i = static_cast<std::size_t>(joint);
    if (i < sim::kMiddleJoints) return kMiddle[i];
    const std::string side = left_of(joint) == joint ? "Left " : "Right ";
    return side + kSide[static_cast<std::size_t>(left_of(joint)) - sim::kMiddleJoints];
}

std::vector<BodyJoint> joints_of(const sim::Body& body) {
    std::vector<BodyJoint> all;
    if (body.skin.empty()) return all;
    std::vector<std::optional<std::size_t>> entry(body.bones.size());  // in the list, of each bone
    const auto add = [&](int bone, std::optional<sim::Joint> joint, std::string title) {
        entry[static_cast<std::size_t>(bone)] = all.size();
        all.push_back({.bone = bone, .joint = joint, .title = std::move(title)});
    };
    const sim::JointBones joints = find_joints(body.bones);
    for (std::size_t i = 0; i < sim::kJointCount; ++i) {
        const auto joint = static_cast<sim::Joint>(i);
        const bool is_new = joints.has(joint) && !entry[static_cast<std::size_t>(joints[joint])];
        if (is_new) add(joints[joint], joint, joint_title(joint));
    }
    for (std::size_t i = 0; i < body.bones.size(); ++i)
        if (!entry[i]) add(static_cast<int>(i), std::nullopt, body.bones[i].name);
    for (BodyJoint& joint : all) {
        int above = body.bones[static_cast<std::size_t>(joint.bone)].parent;
        const auto is_skipped = [&](int bone) {  // a joint of a person hangs on another one
            return joint.joint && !all[*entry[static_cast<std::size_t>(bone)]].joint;
        };
        while (above >= 0 && is_skipped(above)) above = body.bones[static_cast<std::size_t>(above)].parent;
        if (above >= 0) joint.above = entry[static_cast<std::size_t>(above)];
    }
    return all;
}

std::array<AngleLabel, 3> angle_labels(const BodyJoint& joint) {
    constexpr AngleLabel kTwist{.title = "Twist", .tip = "Turns outward about its own length."};
    if (!joint.joint) {
        return {{{.title = "Nod", .tip = "About the axis to the left."},
                 {.title = "Tilt", .tip = "About the axis to the front."},
                 {.title = "Twist", .tip = "About the upward axis."}}};
    }
    const sim::Joint left = left_of(*joint.joint);
    if (static_cast<std::size_t>(left) < sim::kMiddleJoints) {
        return {{{.title = "Bend", .tip = "Bows forward."},
                 {.title = "Lean", .tip = "To the left."},
                 {.title = "Twist", .tip = "Turns to the left."}}};
    }
    constexpr AngleLabel kSpread{.title = "Spread", .tip = "Away from the body."};
    const char* bend = "Swings forward.";
    if (left == sim::Joint::LeftLowerArm || left == sim::Joint::LeftLowerLeg) bend = "Bends the limb.";
    if (left == sim::Joint::LeftHand) bend = "Bends the hand forward.";
    if (left == sim::Joint::LeftFoot || left == sim::Joint::LeftToe) bend = "Lifts the toes.";
    return {{{.title = "Bend", .tip = bend}, kSpread, kTwist}};
}

std::vector<Vec3f> joint_places(const sim::Body& body, const sim::Pose& pose, const std::vector<BodyJoint>& joints) {
    std::vector<Vec3f> places;
    const std::vector<Eigen::Affine3d> frames = bone_frames(body, pose);
    for (const BodyJoint& joint : joints)
        places.emplace_back(frames[static_cast<std::size_t>(joint.bone)].translation().cast<float>());
    return places;
}

Vec3d angles_of(const sim::PoseAngles& angles, const BodyJoint& joint) {
    if (joint.joint) return angles.joints[static_cast<std::size_t>(*joint.joint)];
    const auto found = angles.bones.find(joint.bone);
    return found == angles.bones.end() ? Vec3d(Vec3d::Zero()) : found->second;
}

void set_angles(sim::PoseAngles& angles, const BodyJoint& joint, const Vec3d& to, bool has_both_sides) {
    if (!joint.joint) {
        to.isZero() ? void(angles.bones.erase(joint.bone)) : void(angles.bones[joint.bone] = to);
        return;
    }
    angles.joints[static_cast<std::size_t>(*joint.joint)] = to;
    if (has_both_sides) angles.joints[static_cast<std::size_t>(mirrored(*joint.joint))] = to;
}

Eigen::Quaterniond rotation_of(const BodyJoint& joint, const Vec3d& angles) {
    return joint.joint ? joint_rotation(*joint.joint, angles) : sim::bone_rotation(angles);
}

Vec3d turned_angles(const BodyJoint& joint, const Vec3d& angles, const Eigen::Quaterniond& axes,
                    const Eigen::Quaterniond& turn) {
    const Eigen::Quaterniond to = axes.inverse() * turn * axes * rotation_of(joint, angles);
    return joint.joint ? joint_angles(*joint.joint, to, angles) : sim::bone_angles(to, angles);
}

}  // namespace selvedge::editor
