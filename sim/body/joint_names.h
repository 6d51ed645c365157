#pragma once
// The joints of a person, and how to find them among the bones of a file: by name, in the words of CMU's BVH files,
// MotionBuilder, Mixamo, Unreal and Mesh2Motion, MakeHuman, Blender, 3ds Max, Poser, VRM and SMPL; those of the trunk
// by their place between hips and arms.
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "sim/body/body.h"

namespace selvedge::sim {

// Those of the mannequin. The joints of both sides are in the same order: see mirrored(). A parent precedes its
// children.
enum class Joint {
    Hips,
    Spine,
    Chest,
    Neck,
    Head,
    LeftShoulder,  // of the collarbone
    LeftUpperArm,
    LeftLowerArm,
    LeftHand,
    LeftUpperLeg,
    LeftLowerLeg,
    LeftFoot,
    LeftToe,
    RightShoulder,
    RightUpperArm,
    RightLowerArm,
    RightHand,
    RightUpperLeg,
    RightLowerLeg,
    RightFoot,
    RightToe,
};
inline constexpr std::size_t kJointCount = 21;
inline constexpr std::size_t kMiddleJoints = 5;  // hips to head
inline constexpr std::size_t kSideJoints = 8;

std::string_view joint_name(Joint joint);  // for example "left_upper_arm"
std::optional<Joint> find_joint(std::string_view name);
std::optional<Joint> joint_parent(Joint joint);  // none of the hips
Joint mirrored(Joint joint);

// The bone of each joint; -1 where there is none.
struct JointBones {
    std::array<int, kJointCount> bone{};

    JointBones() { bone.fill(-1); }
    int& operator[](Joint joint) { return bone[static_cast<std::size_t>(joint)]; }
    int operator[](Joint joint) const { return bone[static_cast<std::size_t>(joint)]; }
    bool has(Joint joint) const { return (*this)[joint] >= 0; }
};

// Case, separators, numbers and usual prefixes ("mixamorig:", "Bip01", "DEF-") are ignored. Where a rig calls several
// bones alike, as "leg_joint_L_1" to "_4", they are the joints of the limb in their order. Names that are not known are
// left alone.
JointBones find_joints(const std::vector<Bone>& bones);

// As find_joints(). Throws InputError with Body::file that lists names if neither hips nor a leg nor an arm is found.
JointBones require_joints(const Body& body);

}  // namespace selvedge::sim
