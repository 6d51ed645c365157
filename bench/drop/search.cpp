#include "bench/drop/search.h"

#include <algorithm>
#include <cmath>

namespace selvedge {
namespace {

constexpr const char* kBias = "bias";  // the gate

std::vector<std::string> missed_gates(const DropTrial& trial, const DropGates& gates) {
    std::vector<std::string> missed;
    if (!trial.quality.is_finite) return {"finite"};
    if (!(trial.quality.p99_stretch <= gates.max_stretch)) missed.emplace_back("stretch");
    if (!(trial.quality.area_error <= gates.max_area_error)) missed.emplace_back("area");
    if (!(trial.quality.least_gap >= 0)) missed.emplace_back("inside");
    if (!(std::abs(trial.bias.stiffness_ratio - 1) <= gates.max_bias_error)) missed.emplace_back(kBias);
    return missed;
}

}  // namespace

bool DropTrial::passes_but_for_bias() const {
    return std::ranges::all_of(missed, [](const std::string& gate) { return gate == kBias; });
}

DropTrial try_drop(const SphereDropOptions& options, const DropGates& gates) {
    const SphereDrop drop = run_sphere_drop(options);
    DropTrial trial;
    trial.substeps = options.substeps;
    trial.quality = drop.quality;
    trial.ms_per_frame = drop.ms_per_frame;
    trial.bias = measure_bias(drop_fabric(), {.element = options.scene.side / options.base_quads,
                                              .level = options.scene.level,
                                              .substeps = options.substeps,
                                              .frame_seconds = options.scene.frame_seconds});
    trial.missed = missed_gates(trial, gates);
    return trial;
}

std::optional<int> find_least(int most, const std::function<bool(int)>& passes) {
    int fails = 0;
    int good = std::min(2, most);
    while (!passes(good)) {
        if (good == most) return std::nullopt;
        fails = good;
        good = std::min(2 * good, most);
    }
    while (good - fails > 1) {
        const int middle = fails + (good - fails) / 2;
        (passes(middle) ? good : fails) = middle;
    }
    return good;
}

}  // namespace selvedge
