#pragma once
// The joints of a body as its user sees and turns them: their names, where they are, and what their angles are called.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/joint_names.h"
#include "sim/body/pose.h"
#include "sim/motion/joint_angles.h"

namespace selvedge::editor {

struct BodyJoint {
    int bone = 0;                        // of the body
    std::optional<sim::Joint> joint{};   // of a person; none: another bone
    std::string title{};                 // "Left elbow"; of another bone its own name
    std::optional<std::size_t> above{};  // in the list: the joint that it hangs on
};

// The joints of a person in the order of sim::Joint, then the other bones. None of a body without a skin.
std::vector<BodyJoint> joints_of(const sim::Body& body);

// For example "Left elbow".
std::string joint_title(sim::Joint joint);

// What an angle of a joint does.
struct AngleLabel {
    const char* title;
    const char* tip;
};
std::array<AngleLabel, 3> angle_labels(const BodyJoint& joint);

// Where they are in that pose, m.
std::vector<Vec3f> joint_places(const sim::Body& body, const sim::Pose& pose, const std::vector<BodyJoint>& joints);

// The joint that the user has chosen, and how it is turned.
struct JointChoice {
    std::optional<int> bone{};   // of the present body
    bool has_both_sides = true;  // the joint of the other side turns likewise

    bool operator==(const JointChoice&) const = default;
};

// Of that bone, rad. set_angles() also sets those of the other side if the joint has one and it is wanted.
Vec3d angles_of(const sim::PoseAngles& angles, const BodyJoint& joint);
void set_angles(sim::PoseAngles& angles, const BodyJoint& joint, const Vec3d& to, bool has_both_sides);

// The angles of a joint after a turn in our frame. axes: those about which they count (axes_of_angles).
Vec3d turned_angles(const BodyJoint& joint, const Vec3d& angles, const Eigen::Quaterniond& axes,
                    const Eigen::Quaterniond& turn);
// The joint's rotation for these angles, from its own axes to those about which they count.
Eigen::Quaterniond rotation_of(const BodyJoint& joint, const Vec3d& angles);

}  // namespace selvedge::editor
