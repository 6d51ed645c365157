#pragma once
// Shared by the tests of sim/motion.
#include <cstddef>

#include "sim/body/joint_names.h"
#include "sim/body/skin.h"

namespace selvedge::sim {

inline Vec3d joint_at(const Body& body, const Pose& pose, Joint joint) {
    return bone_frames(body, pose)[std::size_t(find_joints(body.bones)[joint])].translation();
}

}  // namespace selvedge::sim
