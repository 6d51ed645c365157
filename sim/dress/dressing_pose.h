#pragma once
// The pose in which a body is dressed: patterns expect arms that hang at an angle from the trunk, as the mannequin's.
#include "sim/body/body.h"
#include "sim/body/pose.h"

namespace selvedge::sim {

// The rest pose of the body, with its arms as those of the shipped pose "A" where they are held otherwise, for example
// in a T-pose. The rest pose as it is if the arms are not known by name. Pre: the body has bones.
Pose dressing_pose(const Body& body);

}  // namespace selvedge::sim
