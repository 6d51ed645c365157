#include "sim/body/soles.h"

#include <algorithm>
#include <array>
#include <limits>

namespace selvedge::sim {

Soles::Soles(const Body& body, const JointBones& joints, const Eigen::Quaterniond& to_ours)
    : up_(to_ours.inverse() * Vec3d::UnitY()), floor_(std::numeric_limits<double>::infinity()) {
    constexpr double kHeel = 0.25, kTip = 0.35;  // of the way from ankle to toe joint, over the floor
    const std::vector<Eigen::Affine3d> frames = bone_frames(body, rest_pose(body));
    const auto at = [&](Joint joint) { return Vec3d(frames[std::size_t(joints[joint])].translation()); };
    const std::array<std::array<Joint, 2>, 2> feet{
        {{Joint::LeftFoot, Joint::LeftToe}, {Joint::RightFoot, Joint::RightToe}}};
    for (const auto& foot : feet)
        for (const Joint joint : foot)
            if (joints.has(joint)) floor_ = std::min(floor_, up_.dot(at(joint)));
    for (const auto& [ankle, toe] : feet) {
        const auto add = [&](Joint joint, const Vec3d& place) {
            const auto bone = std::size_t(joints[joint]);
            const Vec3d on_floor = place + up_ * (floor_ - up_.dot(place));
            points_.push_back({bone, frames[bone].inverse() * on_floor});
        };
        if (!joints.has(ankle) || !joints.has(toe)) {
            for (const Joint joint : {ankle, toe})
                if (joints.has(joint)) add(joint, at(joint));
            continue;
        }
        const Vec3d way = at(toe) - at(ankle);
        add(ankle, at(ankle) - kHeel * way);
        add(ankle, at(toe));
        add(toe, at(toe) + kTip * way);
    }
}

double Soles::height(const std::vector<Eigen::Affine3d>& frames) const {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Point& point : points_) lowest = std::min(lowest, up_.dot(frames[point.bone] * point.in_bone));
    return lowest - floor_;
}

}  // namespace selvedge::sim
