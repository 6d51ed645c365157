#pragma once
// The mannequin with its arms turned about the shoulders, by its skin weights.
#include <algorithm>
#include <string>

#include "sim/body/body.h"

namespace selvedge::sim::shapes {

// Arms straight out to the sides. Without bones and skin, as a body from a file. Pre: the body is a mannequin.
inline Body in_t_pose(const Body& mannequin) {
    Body body = mannequin;
    for (const std::string side : {"left_", "right_"}) {
        const auto joint = [&](const std::string& name) {
            return std::ranges::find(mannequin.bones, side + name, &Bone::name)->joint;
        };
        const Vec3d shoulder = joint("upper_arm"), along = joint("hand") - shoulder;
        const Vec3d out = along.x() > 0 ? Vec3d(Vec3d::UnitX()) : Vec3d(-Vec3d::UnitX());
        const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(along, out);
        for (std::size_t v = 0; v < body.x.size(); ++v) {
            double share = 0;
            for (std::size_t k = 0; k < 4; ++k) {
                const std::string& name = mannequin.bones[mannequin.skin[v].bones[k]].name;
                if (name == side + "upper_arm" || name == side + "lower_arm" || name == side + "hand")
                    share += static_cast<double>(mannequin.skin[v].weights[k]);
            }
            const Vec3d& x = mannequin.x[v];
            body.x[v] += share * (shoulder + turn * (x - shoulder) - x);
        }
    }
    body.bones.clear();
    body.skin.clear();
    body.made_from.clear();
    return body;
}

}  // namespace selvedge::sim::shapes
