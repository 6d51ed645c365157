#pragma once
// How high the feet of a skeleton are over the floor on which it stands in its rest pose. A skeleton has joints in its
// feet, not the soles: heel, ball and tip are taken to be on the floor below and beyond them, and go with the bones.
//
//      ankle o----.          ball and tip: below the toe joint, and a third of a foot beyond it
//      ______|_____o___      heel: a quarter of a foot behind the ankle
//     heel       ball  tip   floor: the height of the lowest of these joints
#include <vector>

#include "sim/body/body.h"
#include "sim/body/joint_names.h"
#include "sim/body/pose.h"

namespace selvedge::sim {

class Soles {
 public:
    // joints: of the body, whose bones may be in any unit. to_ours: from the frame of bone_frames() to y up.
    Soles(const Body& body, const JointBones& joints,
          const Eigen::Quaterniond& to_ours = Eigen::Quaterniond::Identity());

    bool empty() const { return points_.empty(); }  // whether no foot is known by name
    // Of the lowest point of both soles, in the unit of the bones; negative below the floor. Pre: not empty; the frames
    // of bone_frames().
    double height(const std::vector<Eigen::Affine3d>& frames) const;

 private:
    struct Point {
        std::size_t bone = 0;
        Vec3d in_bone = Vec3d::Zero();
    };
    std::vector<Point> points_;
    Vec3d up_;          // in the frame of bone_frames(), unit
    double floor_ = 0;  // along it
};

}  // namespace selvedge::sim
