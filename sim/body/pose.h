#pragma once
// Poses of a skeleton: a local transform for each bone, blended in proportion and turned joint by joint. (thesis 5.2)
#include <vector>

#include "sim/body/body.h"

namespace selvedge::sim {

// One transform for each bone, to the frame of its parent.
struct Pose {
    std::vector<Transform> bones;
};

// The pose in which the body was read or made: skin(rest_pose(body)) is Body::x up to rounding.
Pose rest_pose(const Body& body);

// `share` 0 gives a, 1 gives b. Rotations are interpolated along the shorter arc.
Transform blend(const Transform& a, const Transform& b, double share);
Pose blend(const Pose& a, const Pose& b, double share);

// Turns a bone, and all that hangs on it, about its joint. The rotation is in the bone's own frame.
void turn_joint(Pose& pose, int bone, const Eigen::Quaterniond& rotation);

// The rotation of a frame, without its scales; none where it has no volume.
Eigen::Quaterniond rotation_of(const Eigen::Affine3d& frame);

// From each bone's frame to ours, m. Pre: the pose has as many bones as the body.
std::vector<Eigen::Affine3d> bone_frames(const Body& body, const Pose& pose);

// From bind positions to positions in that pose, m: G_b B_b of each bone. (thesis listing 5.1)
std::vector<Eigen::Affine3d> skin_transforms(const Body& body, const Pose& pose);

// Index of the bone with this name; -1 when there is none.
int find_bone(const Body& body, const std::string& name);

// For a body whose bones are known by their joints only: rest and inverse bind transforms without rotation.
void set_rest_from_joints(std::vector<Bone>& bones);

// The bind positions from which the skin reproduces Body::x in the rest pose, by solving for each vertex, at the size
// of x: inverse bind transforms change with them. A vertex whose weights cancel out there follows its strongest bone
// alone. Throws InputError with Body::file if a bone that moves vertices has no volume, as with a scale of 0.
void bind_at_rest(Body& body);

}  // namespace selvedge::sim
