#pragma once
// The complete drop experiment, and its results as tables and JSON. All JSON keys are declared here.
#include <optional>
#include <string_view>
#include <vector>

#include "bench/drop/drop.h"
#include "bench/support/table.h"
#include "sim/core/parallel.h"

namespace selvedge::bench {

namespace drop_key {
inline constexpr std::string_view kUsPerTriangleFrame = "us_per_triangle_frame";
inline constexpr std::string_view kMsPerFrame = "ms_per_frame";
inline constexpr std::string_view kMsWithSamples = "ms_with_samples";
inline constexpr std::string_view kP99Stretch = "p99_stretch";
inline constexpr std::string_view kMaxStretch = "max_stretch";
inline constexpr std::string_view kAreaError = "area_error";
inline constexpr std::string_view kSubsteps = "substeps";
inline constexpr std::string_view kTriangles = "triangles";
inline constexpr std::string_view kMeetsGates = "meets_gates";
inline constexpr std::string_view kMissed = "missed";
inline constexpr std::string_view kP1Compression = "p1_compression";
inline constexpr std::string_view kMinGapM = "least_gap_m";
inline constexpr std::string_view kBiasStiffnessRatio = "bias_stiffness_ratio";
inline constexpr std::string_view kRestKineticEnergyJ = "rest_kinetic_energy_j";
inline constexpr std::string_view kRestRmsSpeed = "rest_rms_speed";
inline constexpr std::string_view kRestNetSpeed = "rest_net_speed";
inline constexpr std::string_view kWeightlessEnergyGrowth = "weightless_energy_growth";
inline constexpr std::string_view kWeightlessKineticGrowth = "weightless_kinetic_growth";
inline constexpr std::string_view kConvergedSubsteps = "converged_substeps";
inline constexpr std::string_view kDistanceMeanM = "distance_mean_m";
inline constexpr std::string_view kDistanceRmsM = "distance_rms_m";
inline constexpr std::string_view kNoiseFloorMeanM = "noise_floor_mean_m";
inline constexpr std::string_view kNoiseFloorRmsM = "noise_floor_rms_m";
inline constexpr std::string_view kTrials = "trials";
}  // namespace drop_key

struct DropExperiment {
    int triangles = 1152;
    std::optional<int> substeps{};  // none: searched by measure_drop()
    int max_substeps = 256;
    int repetitions = 5;
    bool passes_quality_checks = true;  // also measures rest, energy and convergence
    DropGates gates{};
    DropScene scene{};
};

struct DropReport {
    int triangles = 0;
    DropTrial chosen;            // given, or the fewest sub-steps that pass, or the last tried
    double ms_per_frame = 0;     // median over the repetitions' medians
    double ms_with_samples = 0;  // the same with contact samples in the middle of triangles
    RestStatistics rest;
    EnergyStatistics weightless;
    std::optional<ConvergenceStatistics> converged;  // none if DropExperiment::passes_quality_checks is false
    std::vector<DropTrial> trials;                   // in ascending order of sub-steps
};

DropReport measure_drop(const DropExperiment& experiment, const sim::Progress& progress = {});

std::vector<Table> tables_of(const DropReport& report);
sim::Json to_json(const DropReport& report);

}  // namespace selvedge::bench
