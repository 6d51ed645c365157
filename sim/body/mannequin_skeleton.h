#pragma once
// The mannequin's 21 joints, their names and their order in Body::bones.
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "sim/body/body.h"
#include "sim/core/vec.h"

namespace selvedge {

// The left side's and the right side's joints come in the same order: see mirrored().
enum class Joint {
    Hips,
    Spine,
    Chest,
    Neck,
    Head,
    LeftShoulder,
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

// Where the joints are, m, by the order of Joint.
struct Joints {
    std::array<Vec3d, kJointCount> x{};

    Vec3d& operator[](Joint joint) { return x[static_cast<std::size_t>(joint)]; }
    const Vec3d& operator[](Joint joint) const { return x[static_cast<std::size_t>(joint)]; }
};

std::string_view joint_name(Joint joint);  // "left_upper_arm"
Joint mirrored(Joint joint);
Vec3d mirrored(const Vec3d& x);  // through the midplane

// Sets the right side's joints to the mirror images of the left side's.
void mirror_left_side(Joints& joints);

std::vector<Bone> make_bones(const Joints& joints);

}  // namespace selvedge
