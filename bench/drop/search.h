#pragma once
// The cheapest number of sub-steps with which the drop meets its gates.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/drop/bias_strip.h"
#include "bench/drop/drop.h"

namespace selvedge {

struct DropGates {
    double max_stretch = 0.05;  // of p99_stretch
    double max_area_error = 0.02;
    double max_bias_error = 0.1;  // of the stiffness on the bias
};

// One number of sub-steps tried.
struct DropTrial {
    int substeps = 0;
    DropQuality quality;
    BiasStrip bias;
    double ms_per_frame = 0;
    std::vector<std::string> missed;  // names of the gates
    bool passes() const { return missed.empty(); }
    bool passes_but_for_bias() const;
};

DropTrial try_drop(const SphereDropOptions& options, const DropGates& gates);

// The least n in 1..most that passes, if passing once means passing with more: gallops 2, 4, 8 .. and bisects. Each n
// is asked once.
std::optional<int> find_least(int most, const std::function<bool(int)>& passes);

}  // namespace selvedge
