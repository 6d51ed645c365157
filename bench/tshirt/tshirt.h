#pragma once
// Measures the time of one adaptation and four steps of a garment that moves slightly on a body, and the shares of
// adaptation and of contact. (thesis 4.5: about 22 ms for a T-shirt of 6,199 triangles on a character of 67,000)
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "bench/support/table.h"
#include "bench/tshirt/dressing.h"

namespace selvedge::bench {

struct SwayOptions {
    float shortest_edge = 0.02F;             // m, shorter edges are not split
    int substeps = 12;                       // per step
    int cycles = 90;                         // of one adaptation and four steps of 1/120 s
    int settling_cycles = 15;                // run first and not measured
    int shares_every = 5;                    // in one cycle of so many, contact is timed
    std::size_t (*allocations)() = nullptr;  // number of heap allocations so far; null: not counted
};

// Gravity is tilted by 5 degrees from the vertical and rotates once per second, so that the garment shifts on the body
// all the time.
struct SwayStatistics {
    int leaf_triangles = 0;  // mean over the measured cycles
    int substeps = 0;        // per step
    double ms_median = 0;    // of one adaptation and four steps
    double ms_p95 = 0;
    double ms_adaptation = 0;           // median
    double ms_steps = 0;                // median, of four steps
    double adapt_share = 0;             // ms_adaptation / ms_median
    double collision_share = 0;         // of the whole: wall-clock time of contact in the steps
    double p99_stretch = 0;             // of warp and weft strain of the leaf triangles, mean over the cycles
    double changes_per_adaptation = 0;  // splits and rejoins, mean
    std::optional<double> allocations_per_adaptation;  // none: not counted
    std::optional<double> allocations_per_step;
};

// Gravity that leans by 5 degrees and goes round once a second, m/s^2.
Vec3f leaning_gravity(double seconds);

SwayStatistics sway(sim::Cloth& cloth, const sim::Collider& body, const SwayOptions& options);

namespace tshirt_key {
inline constexpr std::string_view kLeafTriangles = "leaf_triangles";
inline constexpr std::string_view kMsAdaptPlus4Steps = "ms_adapt_plus_4_steps";
inline constexpr std::string_view kMsAdaptPlus4StepsP95 = "ms_adapt_plus_4_steps_p95";
inline constexpr std::string_view kAdaptShare = "adapt_share";
inline constexpr std::string_view kCollisionShare = "collision_share";
inline constexpr std::string_view kP99Stretch = "p99_stretch";
inline constexpr std::string_view kSubsteps = "substeps";
inline constexpr std::string_view kBodyTriangles = "body_triangles";
inline constexpr std::string_view kMsAdaptation = "ms_adaptation";
inline constexpr std::string_view kMs4Steps = "ms_4_steps";
inline constexpr std::string_view kUsPerLeaf = "us_per_leaf";
inline constexpr std::string_view kChangesPerAdaptation = "changes_per_adaptation";
inline constexpr std::string_view kAllocationsPerAdaptation = "allocations_per_adaptation";
inline constexpr std::string_view kAllocationsPerStep = "allocations_per_step";
inline constexpr std::string_view kRows = "rows";
inline constexpr std::string_view kGrowthWithLeaves = "us_per_leaf_growth_with_leaves";
inline constexpr std::string_view kGrowthWithBody = "growth_with_body";
}  // namespace tshirt_key

struct TshirtExperiment {
    std::filesystem::path pattern;
    int body_triangles = 67000;     // minimum
    int min_leaves = 6000;          // the mean count while the garment moves is 0 to 3 % above this
    double max_stretch = 0.05;      // limit for the 99th percentile of warp and weft strain
    std::optional<int> substeps{};  // per step; none: the fewest that keep the stretch within max_stretch
    bool has_growth = true;         // adds rows with 25,000 leaves and with a body of 500,000 triangles
    SwayOptions sway{};
};

struct TshirtRow {
    std::string what;
    int body_triangles = 0;
    SwayStatistics statistics;
};

struct TshirtReport {
    std::vector<TshirtRow> rows;  // the first is the requested garment
};

TshirtReport measure_tshirt(const TshirtExperiment& experiment, const sim::Progress& progress = {});

Table table_of(const TshirtReport& report);
sim::Json to_json(const TshirtReport& report);

}  // namespace selvedge::bench
