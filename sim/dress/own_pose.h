#pragma once
// A garment that hangs on a body in the pose in which it was dressed, on its way into the body's own pose.
#include <optional>

#include "sim/body/body.h"
#include "sim/body/pose.h"
#include "sim/cloth/cloth.h"
#include "sim/collide/body_collider.h"
#include "sim/core/parallel.h"
#include "sim/dress/drape.h"
#include "sim/dress/dressing.h"

namespace selvedge::sim {

inline constexpr double kToOwnPose = 1.5;  // s, that the body takes

// Whether a body is dressed in another pose than its own.
bool needs_other_pose(const Body& body, const Pose& pose);

// Moves the body from the pose `start` into its rest pose with the cloth on it, and lets the cloth come to rest there,
// unless its drape was given up before: then it gets only the finer sub-steps of the end, and the result says so. own:
// collider of the body in its rest pose. Pre: the body has a skin, and the cloth hangs on it in that pose.
DrapeResult move_to_own_pose(Simulation& simulation, const Body& body, const Pose& start, const BodyCollider& own,
                             const DressOptions& options, std::optional<GiveUp> given_up,
                             const Progress& progress = {});

}  // namespace selvedge::sim
