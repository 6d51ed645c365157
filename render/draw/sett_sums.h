#pragma once
// The tables from which the shader takes the mean colour of any stretch of a sett in two lookups.
#include <vector>

#include "sim/core/math.h"
#include "sim/tartan/sett.h"

namespace selvedge::render {

// Linear light. sums[k] = sum over threads i < k of (colour(i) - mean), k = 0..threads: begins and ends at 0, so it
// repeats with the sett, and stays small enough for float.
struct SettSums {
    Vec3f mean = Vec3f::Zero();
    std::vector<Vec3f> sums;

    int threads() const { return static_cast<int>(sums.size()) - 1; }
};

// Pre: the sett has threads.
SettSums sum_warp(const sim::Sett& sett);
SettSums sum_weft(const sim::Sett& sett);  // the warp's where the weft repeats it

}  // namespace selvedge::render
