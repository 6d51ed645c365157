#pragma once
// A skeleton as retarget() needs it: one that stands in its rest pose, and upright in its motion. Files of games and
// films often have neither. In the zero pose of some, every bone points along an axis of its own, so that a person is a
// straight line; in others, the rest pose stands along one axis and the motion along another.
#include <string>

#include "sim/body/body.h"
#include "sim/body/clip.h"

namespace selvedge::sim {

struct StandUpOptions {
    // The file says so, as all glTF and most FBX do: who stands along y at rest and lies in the motion, lies.
    bool is_y_up = false;
};

// Where needed, turns the motion by right angles, so that the person is upright along y for most of the time, and
// replaces a rest pose that does not stand by the moment of the clip that stands straightest, with its trunk
// straightened, facing the front. Someone who crawls or lies is not turned, as far as legs and floor tell. The clip
// moves the skeleton as before, but for that turn. What was done is added to Clip::notes. Throws
// InputError(Body::file, ...) if the person stands neither at rest nor at any moment. Does nothing to a skeleton whose
// hips, trunk and legs are not known by name.
void stand_up(Body& skeleton, Clip& clip, const StandUpOptions& options = {});

}  // namespace selvedge::sim
