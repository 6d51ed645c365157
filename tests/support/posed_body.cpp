#include "tests/support/posed_body.h"

#include <algorithm>
#include <array>
#include <string>

namespace selvedge::sim::shapes {

namespace {

struct Turn {
    Vec3d centre = Vec3d::Zero();  // m
    Eigen::Quaterniond by = Eigen::Quaterniond::Identity();

    Vec3d operator()(const Vec3d& x) const { return centre + by * (x - centre); }
};

// Turns what belongs to the bones of these names, by its skin weights.
void turn_bones(Body& body, const Body& mannequin, const std::array<std::string, 3>& names, const Turn& turn) {
    for (std::size_t v = 0; v < body.x.size(); ++v) {
        double share = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const std::string& name = mannequin.bones[mannequin.skin[v].bones[k]].name;
            if (std::ranges::find(names, name) != names.end())
                share += static_cast<double>(mannequin.skin[v].weights[k]);
        }
        const Vec3d& x = mannequin.x[v];
        body.x[v] += share * (turn(x) - x);
    }
    for (Bone& bone : body.bones) {
        if (std::ranges::find(names, bone.name) != names.end()) bone.joint = turn(bone.joint);
    }
}

Vec3d joint_of(const Body& mannequin, const std::string& name) {
    return std::ranges::find(mannequin.bones, name, &Bone::name)->joint;
}

}  // namespace

Body in_t_pose(const Body& mannequin) {
    Body body = mannequin;
    for (const std::string side : {"left_", "right_"}) {
        const Vec3d shoulder = joint_of(mannequin, side + "upper_arm");
        const Vec3d along = joint_of(mannequin, side + "hand") - shoulder;
        const Vec3d out = along.x() > 0 ? Vec3d(Vec3d::UnitX()) : Vec3d(-Vec3d::UnitX());
        turn_bones(body, mannequin, {side + "upper_arm", side + "lower_arm", side + "hand"},
                   {shoulder, Eigen::Quaterniond::FromTwoVectors(along, out)});
    }
    body.bones.clear();
    body.skin.clear();
    body.made_from.clear();
    return body;
}

Body in_seat(const Body& mannequin) {
    Body body = mannequin;
    for (const std::string side : {"left_", "right_"}) {
        const Eigen::Quaterniond forward(Eigen::AngleAxisd(-80 * kDegree, Vec3d::UnitX()));
        turn_bones(body, mannequin, {side + "upper_leg", side + "lower_leg", side + "foot"},
                   {joint_of(mannequin, side + "upper_leg"), forward});
    }
    body.made_from.clear();
    return body;
}

}  // namespace selvedge::sim::shapes
