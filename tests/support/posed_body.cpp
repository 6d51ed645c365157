#include "tests/support/posed_body.h"

#include <algorithm>
#include <string>

namespace selvedge::sim::shapes {

Body in_t_pose(const Body& mannequin) {
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
