#include "bench/tshirt/tshirt.h"

#include <cmath>
#include <numbers>

#include "bench/support/cloth_run.h"
#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/step.h"
#include "sim/collide/body_collider.h"
#include "sim/collide/collider.h"
#include "sim/core/gravity.h"
#include "sim/core/math.h"
#include "sim/dress/dressing.h"
#include "sim/mannequin/mannequin.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::bench {
namespace {

constexpr int kManyLeaves = 25000;
constexpr int kDenseBody = 500000;       // triangles
constexpr int kUsualLeaves = 3500;       // of the built-in T-shirt, minus a reserve: fine meshes are refined less
constexpr double kUsualEdge = 0.05;      // m
constexpr float kUsualShortest = 0.02F;  // m

// The body of the pattern, subdivided to at least this many triangles.
sim::Body mannequin_for(const sim::Pattern& pattern, int triangles) {
    const sim::Body body = placed_for(pattern);
    return static_cast<int>(body.triangles.size()) >= triangles ? body : split_triangles(body, triangles);
}

TshirtRow sway_row(const std::string& what, sim::Cloth cloth, const sim::BodyCollider& collider,
                   const SwayOptions& options) {
    set_substep(cloth, 1.0F / static_cast<float>(120 * options.substeps));
    return {.what = what,
            .body_triangles = static_cast<int>(collider.body().triangles.size()),
            .statistics = sway(cloth, collider, options)};
}

// Scales the base mesh and shortest_edge by the same factor: the same garment with the same refinement in smaller
// triangles.
DressingOptions finer_dressing(int leaves) {
    const double scale = std::sqrt(static_cast<double>(kUsualLeaves) / leaves);
    return {.edge_length = kUsualEdge * scale,
            .shortest_edge = kUsualShortest * static_cast<float>(scale),
            .min_leaves = leaves};
}

// The leaf count changes while the garment moves, so it is measured during the motion. Corrects shortest_edge until the
// mean count is 0 to 3 % above min_leaves, in at most 16 trials.
TshirtRow sized_row(const std::string& what, const sim::Cloth& cloth, const sim::BodyCollider& collider,
                    SwayOptions& options, int min_leaves) {
    constexpr int kTrials = 16;
    constexpr double kMax = 1.03, kMiddle = 1.015;  // of min_leaves
    std::optional<float> too_long, too_short;       // m
    for (int trial = 1;; ++trial) {
        TshirtRow row = sway_row(what, cloth, collider, options);
        const int leaves = row.statistics.leaf_triangles;
        const bool is_enough = leaves >= min_leaves, is_too_many = leaves > kMax * min_leaves;
        if (min_leaves == 0 || (is_enough && !is_too_many) || trial == kTrials) return row;
        (is_enough ? too_short : too_long) = options.shortest_edge;
        options.shortest_edge =
            too_long && too_short
                ? std::sqrt(*too_long * *too_short)
                : options.shortest_edge * std::sqrt(static_cast<float>(leaves / (kMiddle * min_leaves)));
    }
}

// Tries 3 sub-steps and more, up to the number used for dressing, until the stretch is within max_stretch.
TshirtRow cheapest_row(const sim::Cloth& cloth, const sim::BodyCollider& collider, SwayOptions& options,
                       const TshirtExperiment& experiment) {
    constexpr int kMin = 3;
    const int most = options.substeps;
    for (options.substeps = kMin;; ++options.substeps) {
        TshirtRow row = sized_row("as asked for", cloth, collider, options, experiment.min_leaves);
        if (row.statistics.p99_stretch <= experiment.max_stretch) return row;
        if (options.substeps < most) continue;
        row.what = "stretch not met";
        return row;
    }
}

double us_per_leaf(const SwayStatistics& statistics) {
    return 1e3 * statistics.ms_median / statistics.leaf_triangles;
}

sim::Json row_json(const TshirtRow& row) {
    const SwayStatistics& f = row.statistics;
    sim::Json json = sim::Json::object();
    json[tshirt_key::kLeafTriangles] = f.leaf_triangles;
    json[tshirt_key::kMsAdaptPlus4Steps] = f.ms_median;
    json[tshirt_key::kMsAdaptPlus4StepsP95] = f.ms_p95;
    json[tshirt_key::kAdaptShare] = f.adapt_share;
    json[tshirt_key::kCollisionShare] = f.collision_share;
    json[tshirt_key::kP99Stretch] = f.p99_stretch;
    json[tshirt_key::kSubsteps] = f.substeps;
    json[tshirt_key::kBodyTriangles] = row.body_triangles;
    json[tshirt_key::kMsAdaptation] = f.ms_adaptation;
    json[tshirt_key::kMs4Steps] = f.ms_steps;
    json[tshirt_key::kUsPerLeaf] = us_per_leaf(f);
    json[tshirt_key::kChangesPerAdaptation] = f.changes_per_adaptation;
    if (f.allocations_per_adaptation) json[tshirt_key::kAllocationsPerAdaptation] = *f.allocations_per_adaptation;
    if (f.allocations_per_step) json[tshirt_key::kAllocationsPerStep] = *f.allocations_per_step;
    return json;
}

}  // namespace

TshirtReport measure_tshirt(const TshirtExperiment& experiment, const sim::Progress& progress) {
    const sim::Pattern pattern = sim::load_pattern(experiment.pattern).pattern;
    const sim::Body body = mannequin_for(pattern, experiment.body_triangles);
    const sim::BodyCollider collider(body);
    TshirtReport report;
    SwayOptions options = experiment.sway;

    const DressedCloth usual = dress_cloth(pattern, body, {.min_leaves = experiment.min_leaves}, progress);
    options.shortest_edge = usual.shortest_edge;
    const int dressed_with = options.substeps;
    if (experiment.substeps) options.substeps = *experiment.substeps;
    report.rows.push_back(experiment.substeps
                              ? sized_row("as asked for", usual.cloth, collider, options, experiment.min_leaves)
                              : cheapest_row(usual.cloth, collider, options, experiment));
    if (!experiment.has_growth) return report;

    const sim::Body dense = mannequin_for(pattern, kDenseBody);
    const sim::BodyCollider dense_collider(dense);
    report.rows.push_back(sway_row("dense body", usual.cloth, dense_collider, options));
    options.substeps = dressed_with;
    report.rows.push_back(sway_row("sub-steps of dressing", usual.cloth, collider, options));
    const DressedCloth many = dress_cloth(pattern, body, finer_dressing(kManyLeaves), progress);
    options.shortest_edge = many.shortest_edge;
    report.rows.push_back(sized_row("many leaves", many.cloth, collider, options, kManyLeaves));
    return report;
}

Table table_of(const TshirtReport& report) {
    Table table{
        .name = "tshirt",
        .title = "One adaptation and four steps of 1/120 s, by processor time",
        .note =
            "Gravity leans by 5 degrees and goes round once a second. Sub-steps per step: the fewest with which the "
            "99th percentile of stretch is at most what was asked for, or what was given; in the last two rows "
            "those of dressing. Contact's share: what the steps take less with nothing to collide with."};
    table.columns = {"garment",
                     "leaf triangles",
                     "body triangles",
                     "sub-steps",
                     "ms, median",
                     "p95",
                     "us per leaf",
                     "adaptation, %",
                     "contact, %",
                     "p99 stretch, %",
                     "changes per adaptation",
                     "allocations per adaptation",
                     "per step"};
    for (const TshirtRow& row : report.rows) {
        const SwayStatistics& f = row.statistics;
        const auto optional_cell = [](const std::optional<double>& v) { return v ? Cell(*v, 1) : Cell(); };
        table.add_row({row.what, f.leaf_triangles, row.body_triangles, f.substeps, Cell(f.ms_median, 3),
                       Cell(f.ms_p95, 3), Cell(us_per_leaf(f), 3), Cell(100 * f.adapt_share, 1),
                       Cell(100 * f.collision_share, 1), Cell(100 * f.p99_stretch, 2),
                       Cell(f.changes_per_adaptation, 1), optional_cell(f.allocations_per_adaptation),
                       optional_cell(f.allocations_per_step)});
    }
    return table;
}

sim::Json to_json(const TshirtReport& report) {
    sim::Json json = row_json(report.rows.front());
    sim::Json& rows = json[tshirt_key::kRows] = sim::Json::array();
    for (const TshirtRow& row : report.rows) {
        sim::Json row_with_name = row_json(row);
        row_with_name["garment"] = row.what;
        rows.push_back(std::move(row_with_name));
    }
    if (report.rows.size() < 4) return json;
    const auto statistics = [&](std::size_t row) -> const SwayStatistics& { return report.rows[row].statistics; };
    json[tshirt_key::kGrowthWithBody] = statistics(1).ms_median / statistics(0).ms_median;
    json[tshirt_key::kGrowthWithLeaves] = us_per_leaf(statistics(3)) / us_per_leaf(statistics(2));
    return json;
}

Vec3f leaning_gravity(double seconds) {
    const double lean = 5 * std::numbers::pi / 180;
    const double turn = 2 * std::numbers::pi * seconds;
    return (sim::kGravity * Vec3d(std::sin(lean) * std::cos(turn), -std::cos(lean), std::sin(lean) * std::sin(turn)))
        .cast<float>();
}

namespace {

constexpr int kSteps = 4;  // of 1/120 s, per adaptation

// Runs cycles and accumulates their times and statistics.
class Cycles {
 public:
    Cycles(sim::Cloth& cloth, const sim::Collider& body, const SwayOptions& options)
        : cloth_(cloth), body_(body), options_(options) {}

    void run(int cycle, bool is_measured) {
        seconds_ = cycle * kSteps / 120.0;
        const std::size_t allocated = allocations();
        const double start = thread_seconds(), wall_start = wall_seconds();
        const sim::AdaptReport adapted = adapt_cloth(cloth_, body_, {.shortest_edge = options_.shortest_edge});
        const double adapted_at = thread_seconds();
        const std::size_t allocated_by_adaptation = allocations() - allocated;
        const std::size_t before_steps = allocations();
        sim::StepTimes times;
        const bool times_parts = cycle % options_.shares_every == 0;
        const double steps = four_steps(times_parts ? &times : nullptr);
        const double whole_wall = wall_seconds() - wall_start;
        if (!is_measured) return;
        const std::size_t allocated_by_steps = allocations() - before_steps;
        if (times_parts) shares_.push_back(times.collision / whole_wall);
        add(adapted_at - start, steps, adapted.splits + adapted.rejoins);
        adaptation_allocations_ += allocated_by_adaptation;
        step_allocations_ += allocated_by_steps;
    }

    SwayStatistics statistics() const {
        const auto count = static_cast<double>(whole_.size());
        SwayStatistics f;
        f.leaf_triangles = static_cast<int>(std::lround(leaves_ / count));
        f.substeps = options_.substeps;
        f.ms_median = 1e3 * sim::quantile(whole_, 0.5);
        f.ms_p95 = 1e3 * sim::quantile(whole_, 0.95);
        f.ms_adaptation = 1e3 * sim::quantile(adaptations_, 0.5);
        f.ms_steps = 1e3 * sim::quantile(steps_, 0.5);
        f.adapt_share = f.ms_adaptation / f.ms_median;
        f.collision_share = sim::quantile(shares_, 0.5);
        f.p99_stretch = stretch_ / count;
        f.changes_per_adaptation = changes_ / count;
        if (options_.allocations != nullptr) {
            f.allocations_per_adaptation = static_cast<double>(adaptation_allocations_) / count;
            f.allocations_per_step = static_cast<double>(step_allocations_) / count / kSteps;
        }
        return f;
    }

 private:
    std::size_t allocations() const { return options_.allocations == nullptr ? 0 : options_.allocations(); }

    double four_steps(sim::StepTimes* times) const {
        const double start = thread_seconds();
        for (int i = 0; i < kSteps; ++i) {
            step(cloth_, body_,
                 {.substeps = options_.substeps,
                  .gravity = leaning_gravity(seconds_ + i / 120.0),
                  .extra_damping = 2,
                  .times = times});
        }
        return thread_seconds() - start;
    }

    void add(double adaptation, double steps, int changes) {
        adaptations_.push_back(adaptation);
        steps_.push_back(steps);
        whole_.push_back(adaptation + steps);
        changes_ += changes;
        leaves_ += static_cast<double>(cloth_.mesh.leaf_triangles().size());
        std::vector<double> strains;
        for (const sim::TriangleStrain& strain : measure_strain(cloth_)) {
            strains.push_back(static_cast<double>(strain.warp));
            strains.push_back(static_cast<double>(strain.weft));
        }
        stretch_ += sim::quantile(strains, 0.99);
    }

    sim::Cloth& cloth_;
    const sim::Collider& body_;
    const SwayOptions& options_;
    double seconds_ = 0;
    std::vector<double> adaptations_, steps_, whole_, shares_;
    double leaves_ = 0;
    double stretch_ = 0;
    double changes_ = 0;
    std::size_t adaptation_allocations_ = 0;
    std::size_t step_allocations_ = 0;
};

}  // namespace

SwayStatistics sway(sim::Cloth& cloth, const sim::Collider& body, const SwayOptions& options) {
    Cycles cycles(cloth, body, options);
    for (int cycle = 0; cycle < options.settling_cycles + options.cycles; ++cycle)
        cycles.run(cycle, cycle >= options.settling_cycles);
    return cycles.statistics();
}

}  // namespace selvedge::bench
