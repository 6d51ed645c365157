#include "sim/motion/joint_angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "sim/body/clip.h"
#include "sim/core/json.h"
#include "sim/core/math.h"
#include "sim/motion/clear_arms.h"
#include "sim/motion/grounding.h"
#include "sim/motion/retarget.h"

namespace selvedge::sim {
namespace {

using Rotation = Eigen::Quaterniond;

constexpr double kUnturned = 1e-6;  // rad: below this a bone counts as not turned

// A person of 1.65 m with legs and arms straight down: the female mannequin's bones (mannequin_table.json),
// straightened.
constexpr std::array<std::array<double, 3>, kJointCount> kUpright{{
    {0, 0.833, 0},           {0, 0.906, 0},       {0, 1.060, 0},
    {0, 1.358, 0},           {0, 1.470, 0},       {0.0229, 1.290, 0},
    {0.1554, 1.275, 0},      {0.1554, 1.0408, 0}, {0.1554, 0.828, 0},
    {0.0955, 0.8271, 0},     {0.0955, 0.4515, 0}, {0.0955, 0.069, 0},
    {0.0955, 0.0237, 0.123}, {-0.0229, 1.290, 0}, {-0.1554, 1.275, 0},
    {-0.1554, 1.0408, 0},    {-0.1554, 0.828, 0}, {-0.0955, 0.8271, 0},
    {-0.0955, 0.4515, 0},    {-0.0955, 0.069, 0}, {-0.0955, 0.0237, 0.123},
}};

bool is_of_trunk(Joint joint) {
    return std::size_t(joint) < kMiddleJoints;
}

// Each sign turns an angle from its meaning to the right-hand rule about x, z and y.
Vec3d signs_of(Joint joint) {
    if (is_of_trunk(joint)) return {1, -1, 1};
    const bool is_left = std::size_t(joint) < kMiddleJoints + kSideJoints;
    const Joint left = is_left ? joint : mirrored(joint);
    const double side = is_left ? 1 : -1;
    return {left == Joint::LeftLowerLeg ? 1.0 : -1.0, side, side};
}

// The angle nearest to `near` among those that differ by full turns.
double unwound(double angle, double near) {
    return near + std::remainder(angle - near, 2 * std::numbers::pi);
}

// R_x(a) R_z(b) R_y(c) of angles (a, b, c).
Rotation rotation_xzy(const Vec3d& angles) {
    return Rotation(Eigen::AngleAxisd(angles[0], Vec3d::UnitX()) * Eigen::AngleAxisd(angles[1], Vec3d::UnitZ()) *
                    Eigen::AngleAxisd(angles[2], Vec3d::UnitY()));
}

// The first entry of its rows is (cos b cos c, -sin b, cos b sin c), its middle column (-sin b, cos a cos b, sin a cos
// b). Where cos b is 0, only the sum or the difference of a and c is known: a stays as it is in `near`.
Vec3d angles_xzy(const Rotation& rotation, const Vec3d& near) {
    constexpr double kLocked = 1e-6;
    const Eigen::Matrix3d r = rotation.toRotationMatrix();
    const double b = std::asin(std::clamp(-r(0, 1), -1.0, 1.0));
    std::array<Vec3d, 2> both{Vec3d(std::atan2(r(2, 1), r(1, 1)), b, std::atan2(r(0, 2), r(0, 0))), Vec3d::Zero()};
    if (std::abs(std::cos(b)) < kLocked) {
        const Eigen::Matrix3d rest = (rotation_xzy({near[0], b, 0}).inverse() * rotation).toRotationMatrix();
        both[0] = {near[0], b, std::atan2(rest(0, 2), rest(0, 0))};
    }
    both[1] = both[0] + Vec3d(std::numbers::pi, 0, std::numbers::pi);
    both[1][1] = std::numbers::pi - both[0][1];
    for (Vec3d& one : both)
        for (Eigen::Index k = 0; k < 3; ++k) one[k] = unwound(one[k], near[k]);
    return (both[0] - near).norm() <= (both[1] - near).norm() ? both[0] : both[1];
}

Clip clip_of(const std::vector<Rotation>& rotations) {
    Clip clip{.name = "pose"};
    for (std::size_t i = 0; i < rotations.size(); ++i)
        clip.tracks.push_back({.bone = int(i), .rotation = {{0.0}, {rotations[i]}}});
    return clip;
}

bool can_be_retargeted(const JointBones& joints) {
    return std::ranges::any_of(
        std::array{Joint::Hips, Joint::LeftUpperArm, Joint::RightUpperArm, Joint::LeftUpperLeg, Joint::RightUpperLeg},
        [&](Joint joint) { return joints.has(joint); });
}

// The pose of the joints, on the body.
std::optional<Clip> fitted(const PoseAngles& angles, const Body& body) {
    if (!can_be_retargeted(find_joints(body.bones))) return std::nullopt;
    std::vector<Rotation> rotations;
    for (std::size_t i = 0; i < kJointCount; ++i) rotations.push_back(joint_rotation(Joint(i), angles.joints[i]));
    return retarget(upright_skeleton("pose"), clip_of(rotations), body);
}

Rotation parent_rotation(const Body& body, const std::vector<Eigen::Affine3d>& frames, int bone) {
    const int parent = body.bones[std::size_t(bone)].parent;
    return rotation_of(parent < 0 ? body.frame : frames[std::size_t(parent)]);
}

bool is_joint(const JointBones& joints, int bone) {
    return std::ranges::find(joints.bone, bone) != joints.bone.end();
}

double degrees(double radians) {
    constexpr double kDigits = 1000;  // 0.001 degrees move a hand by 0.01 mm
    return std::round(kDigits * std::remainder(radians, 2 * std::numbers::pi) / kDegree) / kDigits;
}

}  // namespace

Body upright_skeleton(const std::string& file) {
    Body body;
    body.name = body.file = file;
    for (std::size_t i = 0; i < kJointCount; ++i) {
        const Joint joint = Joint(i);
        const std::optional<Joint> parent = joint_parent(joint);
        const auto& [x, y, z] = kUpright[i];
        body.bones.push_back(
            {.name = std::string(joint_name(joint)), .parent = parent ? int(*parent) : -1, .joint = Vec3d(x, y, z)});
    }
    set_rest_from_joints(body.bones);
    return body;
}

std::array<std::string_view, 3> angle_names(Joint joint) {
    return {"flex", is_of_trunk(joint) ? "lean" : "spread", "turn"};
}

Rotation joint_rotation(Joint joint, const Vec3d& angles) {
    return rotation_xzy(signs_of(joint).cwiseProduct(angles));
}

Vec3d joint_angles(Joint joint, const Rotation& rotation, const Vec3d& near) {
    const Vec3d signs = signs_of(joint);
    return signs.cwiseProduct(angles_xzy(rotation, signs.cwiseProduct(near)));
}

Rotation bone_rotation(const Vec3d& angles) {
    return rotation_xzy(angles);
}

Vec3d bone_angles(const Rotation& rotation, const Vec3d& near) {
    return angles_xzy(rotation, near);
}

PoseAngles pose_angles(const Body& body, const Pose& pose) {
    PoseAngles angles;
    const JointBones joints = find_joints(body.bones);
    if (can_be_retargeted(joints)) {
        std::vector<Rotation> rotations;
        for (const Transform& bone : pose.bones) rotations.push_back(bone.rotation);
        const Body upright = upright_skeleton("pose");
        const Pose stands = sample(upright, retarget(body, clip_of(rotations), upright), 0);
        for (std::size_t i = 0; i < kJointCount; ++i)
            angles.joints[i] = joint_angles(Joint(i), stands.bones[i].rotation);
    }
    const std::optional<Clip> clip = fitted(angles, body);
    const Pose rest = rest_pose(body), of_joints = clip ? sample(body, *clip, 0) : rest;
    const std::vector<Eigen::Affine3d> frames = bone_frames(body, rest);
    for (int bone = 0; bone < int(body.bones.size()); ++bone) {
        if (is_joint(joints, bone)) continue;
        const Rotation to_ours = parent_rotation(body, frames, bone);
        const Rotation local =
            pose.bones[std::size_t(bone)].rotation * of_joints.bones[std::size_t(bone)].rotation.inverse();
        if (local.angularDistance(Rotation::Identity()) < kUnturned) continue;
        angles.bones[bone] = bone_angles(to_ours * local * to_ours.inverse());
    }
    return angles;
}

Pose pose_of(const PoseAngles& angles, const Body& body) {
    std::optional<Clip> clip = fitted(angles, body);
    if (clip) clear_arms(body, *clip);
    Pose pose = clip ? sample(body, *clip, 0) : rest_pose(body);
    const std::vector<Eigen::Affine3d> frames = bone_frames(body, rest_pose(body));
    for (const auto& [bone, turned] : angles.bones) {
        if (bone < 0 || bone >= int(body.bones.size())) continue;
        const Rotation to_ours = parent_rotation(body, frames, bone);
        Rotation& local = pose.bones[std::size_t(bone)].rotation;
        local = (to_ours.inverse() * bone_rotation(turned) * to_ours * local).normalized();
    }
    if (!body.skin.empty()) stand_on_floor(body, pose);
    return pose;
}

Rotation axes_of_angles(const Body& body, const Pose& pose, const PoseAngles& angles, int bone) {
    const JointBones joints = find_joints(body.bones);
    const auto found = std::ranges::find(joints.bone, bone);
    if (found == joints.bone.end()) {
        return parent_rotation(body, bone_frames(body, pose), bone) *
               parent_rotation(body, bone_frames(body, rest_pose(body)), bone).inverse();
    }
    Rotation axes = Rotation::Identity();
    std::optional<Joint> above = joint_parent(Joint(found - joints.bone.begin()));
    for (; above; above = joint_parent(*above))
        axes = joint_rotation(*above, angles.joints[std::size_t(*above)]) * axes;
    return axes;
}

std::string write_pose(const PoseAngles& angles, const std::string& name) {
    Json joints = Json::object();
    for (std::size_t i = 0; i < kJointCount; ++i) {
        Json turned = Json::object();
        const std::array<std::string_view, 3> names = angle_names(Joint(i));
        for (std::size_t k = 0; k < 3; ++k)
            if (const double value = degrees(angles.joints[i][Eigen::Index(k)]); value != 0) turned[names[k]] = value;
        if (!turned.members().empty()) joints[joint_name(Joint(i))] = std::move(turned);
    }
    Json pose = Json::object();
    pose["name"] = name;
    pose["times"] = Json::array({0});
    pose["joints"] = std::move(joints);
    return write_json(pose);
}

}  // namespace selvedge::sim
