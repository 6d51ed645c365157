#pragma once
// Shared by the tests of sim/collide.
#include <limits>

namespace selvedge::sim {

inline constexpr float kFar = std::numeric_limits<float>::infinity();  // m: a search that finds the nearest anywhere

}  // namespace selvedge::sim
