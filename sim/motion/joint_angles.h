#pragma once
// A pose by the angles of a person's joints, as files of poses hold them (patterns/FORMAT.md): read off a body, changed
// joint by joint, put on any body, and written to a file.
//
// Angles count from the joint that a joint hangs on, of a person who stands upright with arms and legs straight down.
// The rotation is R_x(flex) R_z(spread) R_y(turn): flexion, abduction, axial rotation. (Grood and Suntay 1983)
#include <array>
#include <map>
#include <string>
#include <string_view>

#include "sim/body/body.h"
#include "sim/body/joint_names.h"
#include "sim/body/pose.h"

namespace selvedge::sim {

// Each is rad: flex; spread, or lean for joints of the trunk; turn.
struct PoseAngles {
    std::array<Vec3d, kJointCount> joints{};
    // Of bones that are no joint of a person, such as those of fingers: by how much they are turned from where they are
    // in the pose of the joints, about the axes to the left, to the front and upward of the rest pose, which go along
    // with the parent. Bones that are not turned are left out.
    std::map<int, Vec3d> bones{};

    PoseAngles() { joints.fill(Vec3d::Zero()); }
    bool operator==(const PoseAngles&) const = default;
};

inline constexpr double kUprightLegLength = 0.8271 - 0.069;  // m, hip to ankle of the upright person

// The person from whose pose angles count: a skeleton with a bone for each joint, in the order of Joint.
Body upright_skeleton(const std::string& file);

// As files call them: "flex", "spread" or "lean", "turn".
std::array<std::string_view, 3> angle_names(Joint joint);

// From the frame of the joint to that of its parent, and back. Of the triples of angles that give the same rotation,
// the one nearest to `near`.
Eigen::Quaterniond joint_rotation(Joint joint, const Vec3d& angles);
Vec3d joint_angles(Joint joint, const Eigen::Quaterniond& rotation, const Vec3d& near = Vec3d::Zero());
// The same of a bone that is no joint.
Eigen::Quaterniond bone_rotation(const Vec3d& angles);
Vec3d bone_angles(const Eigen::Quaterniond& rotation, const Vec3d& near = Vec3d::Zero());

// The angles of the body in that pose. Joints that it does not have are at 0. Pre: the pose is one of the body.
PoseAngles pose_angles(const Body& body, const Pose& pose);

// The pose of the body with these angles, as find_pose() makes it of a file: on the floor, with arms that do not cut
// the trunk. Bones that it does not have are ignored.
Pose pose_of(const PoseAngles& angles, const Body& body);

// The axes about which the angles of that bone count, in our frame, where the body is in that pose with those angles:
// x to the left, y upward and z to the front of a person who stands upright.
Eigen::Quaterniond axes_of_angles(const Body& body, const Pose& pose, const PoseAngles& angles, int bone);

// A file of this pose. Bones that are no joint are not in it.
std::string write_pose(const PoseAngles& angles, const std::string& name);

}  // namespace selvedge::sim
