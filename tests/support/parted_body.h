#pragma once
// A body of separate parts, as games build them: a closed shell for each part of the body that moves alone, and balls
// at the joints between them.
#include "sim/body/body.h"

namespace selvedge::sim::shapes {

enum class Joints {
    Balls,  // the largest that the skin holds: shells and balls overlap
    Gaps,   // nothing: shells are some centimetres apart
};

// The mannequin's skin cut up by its weights; each part is bound to one bone, and the bones have Mixamo's names. Pre:
// the body is a mannequin.
Body in_parts(const Body& mannequin, Joints joints);

}  // namespace selvedge::sim::shapes
