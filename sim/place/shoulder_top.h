#pragma once
// Where a garment hangs: the top of a body's shoulders.
#include <optional>

#include "sim/place/measured_body.h"

namespace selvedge::sim {

// The mean height of the surface of both shoulders beside the neck, m, in any pose of the arms. None if it lies where
// no person has shoulders.
std::optional<double> shoulder_top(const MeasuredBody& body);

}  // namespace selvedge::sim
