#include "sim/body/mannequin_skeleton.h"

#include <string>

namespace selvedge {

namespace {

struct JointEntry {
    std::string_view name;
    int parent;
};

constexpr std::array<JointEntry, kJointCount> kJoints{{
    {"hips", -1},
    {"spine", 0},
    {"chest", 1},
    {"neck", 2},
    {"head", 3},
    {"left_shoulder", 2},
    {"left_upper_arm", 5},
    {"left_lower_arm", 6},
    {"left_hand", 7},
    {"left_upper_leg", 0},
    {"left_lower_leg", 9},
    {"left_foot", 10},
    {"left_toe", 11},
    {"right_shoulder", 2},
    {"right_upper_arm", 13},
    {"right_lower_arm", 14},
    {"right_hand", 15},
    {"right_upper_leg", 0},
    {"right_lower_leg", 17},
    {"right_foot", 18},
    {"right_toe", 19},
}};

}  // namespace

std::string_view joint_name(Joint joint) {
    return kJoints[static_cast<std::size_t>(joint)].name;
}

Joint mirrored(Joint joint) {
    const auto i = static_cast<std::size_t>(joint);
    if (i < kMiddleJoints) return joint;
    return static_cast<Joint>(i < kMiddleJoints + kSideJoints ? i + kSideJoints : i - kSideJoints);
}

Vec3d mirrored(const Vec3d& x) {
    return {-x.x(), x.y(), x.z()};
}

void mirror_left_side(Joints& joints) {
    for (std::size_t i = kMiddleJoints; i < kMiddleJoints + kSideJoints; ++i) {
        const auto left = static_cast<Joint>(i);
        joints[mirrored(left)] = mirrored(joints[left]);
    }
}

std::vector<Bone> make_bones(const Joints& joints) {
    std::vector<Bone> bones;
    for (std::size_t i = 0; i < kJointCount; ++i) {
        bones.push_back({.name = std::string(kJoints[i].name), .parent = kJoints[i].parent, .joint = joints.x[i]});
    }
    return bones;
}

}  // namespace selvedge
