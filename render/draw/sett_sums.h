#pragma once
// Prefix sums of a sett's colours. With them the shader gets the mean colour of any stretch of a sett in two lookups.
#include <vector>

#include "sim/core/math.h"
#include "sim/tartan/sett.h"

namespace selvedge::render {

// Linear light. sums[k] = sum over threads i < k of (colour(i) - mean), k = 0..threads. Because the mean is subtracted,
// the sums begin and end at 0, so they repeat with the sett and stay small enough for float precision.
struct SettSums {
    Vec3f mean = Vec3f::Zero();
    std::vector<Vec3f> sums;

    int threads() const { return static_cast<int>(sums.size()) - 1; }
};

// Pre: the sett has threads.
SettSums sum_warp(const sim::Sett& sett);
SettSums sum_weft(const sim::Sett& sett);  // equals the warp's if the weft repeats it

}  // namespace selvedge::render
