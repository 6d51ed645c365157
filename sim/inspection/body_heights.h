#pragma once
// The heights of a body's joints, between which a place on one body is found on another (sim/place/level_on.h).
#include <vector>

#include "sim/place/limbs.h"

namespace selvedge::sim {

// The heights of a body's joints, m: floor, hips, waist, chest, neck, top.
using Heights = std::vector<double>;

Heights heights_of(const BodyLimbs& body);

// As those of a body that stands.
bool is_ascending(const Heights& heights);

}  // namespace selvedge::sim
