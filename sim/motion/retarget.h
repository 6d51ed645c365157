#pragma once
// A clip of one skeleton played on another. Joints are matched by name (joint_names.h). Each bone is first turned from
// the target's rest direction to that of the source, which makes a T-pose, an A-pose and the zero pose of a BVH file
// comparable; then it turns in the world as the source's bone turns from its rest pose. The hips move as the source's,
// by the ratio of the legs' lengths, but never so that the feet are below the floor or higher over it than the
// source's. (Intermediate skeleton: Monzani, Baerlocher, Boulic, Thalmann 2000)
#include "sim/body/body.h"
#include "sim/body/clip.h"

namespace selvedge::sim {

struct RetargetOptions {
    // Moves the whole course so that the hips start over the place where they rest; otherwise they keep the source's
    // distance from its rest pose.
    bool starts_at_rest = true;
};

// Both bodies may be in any unit and axes; the clip is one of the source. The result has the source's times, and more
// where they are farther apart than 1/30 s. Where the source has no such joint, the bone keeps its rest pose relative
// to its parent, but those of the trunk share the turn from hips to chest. Joints that the target does not have fold
// into those that hang on them. Other bones, as of fingers, turn with those of the same name. Scales are not
// transferred. Throws InputError if a skeleton has no joint of a person that is known by name, or if the result would
// have more keys than `limits` allows. Clip::notes of the result tells what is guessed; those of the clip are not
// taken.
Clip retarget(const Body& source, const Clip& clip, const Body& target, const RetargetOptions& options = {},
              const ClipLimits& limits = {});

}  // namespace selvedge::sim
