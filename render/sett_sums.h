#pragma once
// The table from which the shader takes the mean colour of any stretch of a sett in two lookups.
#include <vector>

#include "sim/core/vec.h"
#include "sim/tartan/sett.h"

namespace selvedge {

// Linear light. sums[k] = sum over threads i < k of (colour(i) - mean), k = 0..threads: begins and ends at 0, so it
// repeats with the sett, and stays small enough for float. Pre: the sett has threads.
struct SettSums {
    Vec3f mean = Vec3f::Zero();
    std::vector<Vec3f> sums;
};

SettSums sum_sett(const Sett& sett);

}  // namespace selvedge
