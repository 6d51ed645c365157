#pragma once
// The heights of a body's joints, by which a place on one body is found on another.
#include <vector>

#include "sim/place/limbs.h"

namespace selvedge::sim {

// The heights of a body's joints, m: floor, hips, waist, chest, neck, top.
using Heights = std::vector<double>;

Heights heights_of(const BodyLimbs& body);

// As those of a body that stands.
bool is_ascending(const Heights& heights);

// The height on the other body between the same joints; linear beyond the ends. Pre: both are ascending.
double carry_over(double y, const Heights& from, const Heights& to);

}  // namespace selvedge::sim
