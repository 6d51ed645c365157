#pragma once
// The pose in which a body is dressed, and the way from there into its own pose. Patterns expect arms that hang at an
// angle from the trunk, as the mannequin's. A body that holds them otherwise lowers them, and raises them again with
// the garment on it.
#include <optional>

#include "sim/body/body.h"
#include "sim/body/pose.h"
#include "sim/cloth/cloth.h"
#include "sim/collide/body_collider.h"
#include "sim/core/parallel.h"
#include "sim/dress/drape.h"
#include "sim/dress/dressing.h"

namespace selvedge::sim {

// The rest pose of the body, with its arms as those of the shipped pose "A" where they are held otherwise, for example
// in a T-pose. The rest pose as it is if the arms are not known by name. Pre: the body has bones.
Pose dressing_pose(const Body& body);

// Whether a body is dressed in another pose than its own.
bool needs_other_pose(const Body& body, const Pose& pose);

// Moves the body from the pose `start` into its rest pose with the cloth on it, and lets the cloth come to rest there,
// unless its drape, `draped`, was given up before: then it gets only the finer sub-steps of the end, and the result
// says so. own: collider of the body in its rest pose. Pre: the body has a skin, and the cloth hangs on it in that
// pose.
DrapeResult move_to_own_pose(Simulation& simulation, const Body& body, const Pose& start, const BodyCollider& own,
                             const DressOptions& options, const DrapeResult& draped, const Progress& progress = {});

}  // namespace selvedge::sim
