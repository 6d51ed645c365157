#pragma once
// Where a garment hangs: the top of a body's shoulders.
#include <optional>

namespace selvedge::sim {

class MeasuredBody;

// The mean height of the surface of both shoulders beside the neck, m, in any pose of the arms. None if it lies where
// no person has shoulders.
std::optional<double> find_shoulder_top(const MeasuredBody& body);

}  // namespace selvedge::sim
