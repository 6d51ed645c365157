#pragma once
// Gravity, in one place for the solver, the checks of a worn garment and the experiments.
#include "sim/core/math.h"

namespace selvedge::sim {

inline constexpr double kGravity = 9.81;  // g, m/s^2: the standard 9.80665, rounded

inline Vec3f standard_gravity() {
    return {0, -static_cast<float>(kGravity), 0};
}

}  // namespace selvedge::sim
