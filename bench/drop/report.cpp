#include "bench/drop/report.h"

#include <algorithm>

#include "sim/core/math.h"

namespace selvedge::bench {
namespace {

SphereDropOptions options_for(const DropExperiment& experiment, int substeps) {
    return {.base_quads = base_quads_for(experiment.triangles, experiment.scene),
            .substeps = substeps,
            .scene = experiment.scene};
}

// Runs trials and remembers them, so that each number of sub-steps is tried once.
class Trials {
 public:
    Trials(const DropExperiment& experiment, std::vector<DropTrial>& trials, const sim::Progress& progress)
        : experiment_(experiment), trials_(trials), progress_(progress) {}

    const DropTrial& at(int substeps) {
        const auto known = std::ranges::find(trials_, substeps, &DropTrial::substeps);
        if (known != trials_.end()) return *known;
        sim::report(progress_, "searching: " + std::to_string(substeps) + " sub-steps", 0);
        return trials_.emplace_back(try_drop(options_for(experiment_, substeps), experiment_.gates));
    }

    // The fewest sub-steps that pass. Stretch and area improve with more sub-steps, so they allow bisection. The
    // stiffness on the bias varies slightly from one number to the next, so from the result of the bisection every
    // number is tried in turn, up to 1.5 times that result.
    std::optional<int> fewest() {
        const auto holds = [&](int substeps) { return at(substeps).passes_but_for_bias(); };
        const std::optional<int> least = find_least(experiment_.max_substeps, holds);
        if (!least) return std::nullopt;
        const int last = std::min(experiment_.max_substeps, *least + *least / 2);
        for (int substeps = *least; substeps <= last; ++substeps) {
            if (at(substeps).passes()) return substeps;
        }
        return std::nullopt;
    }

 private:
    const DropExperiment& experiment_;
    std::vector<DropTrial>& trials_;
    const sim::Progress& progress_;
};

// Returns the chosen trial; leaves all trials in ascending order of sub-steps.
DropTrial search(const DropExperiment& experiment, std::vector<DropTrial>& trials, const sim::Progress& progress) {
    Trials tried(experiment, trials, progress);
    std::optional<int> found = experiment.substeps;
    if (found) {
        tried.at(*found);
    } else {
        found = tried.fewest();
    }
    const int wanted = found.value_or(trials.back().substeps);
    std::ranges::sort(trials, {}, &DropTrial::substeps);
    return *std::ranges::find(trials, wanted, &DropTrial::substeps);
}

// Four times as many, within 64..128. In much shorter sub-steps, the displacement by gravity is lost in the rounding of
// the single-precision positions.
int converged_substeps(int substeps) {
    return std::max(std::clamp(4 * substeps, 64, 128), substeps);
}

void measure_quality(const SphereDropOptions& options, DropReport& report, const sim::Progress& progress) {
    sim::report(progress, "converged runs", 0);
    SphereDrop drop = run_sphere_drop(options);
    report.converged = compare_converged(drop, options, converged_substeps(options.substeps));
    sim::report(progress, "without gravity", 0);
    ClothRun copy = drop.run;
    report.weightless = weightless(copy, options.scene);
    sim::report(progress, "coming to rest", 0);
    report.rest = rest_after(drop.run, options.scene);
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
}

std::vector<Cell> trial_cells(const DropTrial& trial) {
    const DropQuality& q = trial.quality;
    return {trial.substeps,
            Cell(trial.ms_per_frame, 4),
            Cell(q.p99_stretch, 4),
            Cell(q.max_stretch, 4),
            Cell(q.p1_compression, 4),
            Cell(q.area_error, 4),
            Cell(1e3 * q.min_gap, 3),
            Cell(trial.bias.stiffness_ratio, 3),
            trial.passes() ? "all met" : "missed: " + joined(trial.missed)};
}

Table trial_table(const DropReport& report) {
    Table table{
        .name = "drop",
        .title = std::to_string(report.triangles) + " triangles dropped on a sphere, by processor time",
        .note = "Sub-steps per frame of 1/60 s, each number tried once; ms per frame: median of frames 46 to 90."};
    table.columns = {"sub-steps",  "ms per frame",  "p99 stretch",    "max stretch", "p1",
                     "area error", "least gap, mm", "bias stiffness", "gates"};
    for (const DropTrial& trial : report.trials) table.add_row(trial_cells(trial));
    return table;
}

Table quality_table(const DropReport& report) {
    Table table{.name = "drop honesty", .title = "What the chosen setting does when nobody times it"};
    table.columns = {"figure", "value"};
    const ConvergenceStatistics& converged = *report.converged;
    table.add_row({"kinetic energy after 10 s of rest, mJ", Cell(1e3 * report.rest.kinetic_energy, 4)});
    table.add_row({"rms speed then, mm/s", Cell(1e3 * report.rest.rms_speed, 3)});
    table.add_row({"rms net speed over the last second, mm/s", Cell(1e3 * report.rest.net_speed, 3)});
    table.add_row({"energy growth without gravity", Cell(report.weightless.energy_growth, 5)});
    table.add_row({"kinetic energy growth without gravity", Cell(report.weightless.kinetic_growth, 5)});
    table.add_row({"sub-steps of the converged run", converged.substeps});
    table.add_row({"mean distance to it, mm", Cell(1e3 * converged.distance.mean, 2)});
    table.add_row({"rms distance to it, mm", Cell(1e3 * converged.distance.rms, 2)});
    table.add_row({"mean noise floor, mm", Cell(1e3 * converged.noise_floor.mean, 2)});
    table.add_row({"rms noise floor, mm", Cell(1e3 * converged.noise_floor.rms, 2)});
    return table;
}

sim::Json trial_json(const DropTrial& trial, double ms_per_frame, int triangles) {
    const DropQuality& q = trial.quality;
    sim::Json json = sim::Json::object();
    json[drop_key::kUsPerTriangleFrame] = 1e3 * ms_per_frame / triangles;
    json[drop_key::kMsPerFrame] = ms_per_frame;
    json[drop_key::kP99Stretch] = q.p99_stretch;
    json[drop_key::kMaxStretch] = q.max_stretch;
    json[drop_key::kAreaError] = q.area_error;
    json[drop_key::kSubsteps] = trial.substeps;
    json[drop_key::kP1Compression] = q.p1_compression;
    json[drop_key::kMinGapM] = q.min_gap;
    json[drop_key::kBiasStiffnessRatio] = trial.bias.stiffness_ratio;
    json[drop_key::kMeetsGates] = trial.passes();
    json[drop_key::kMissed] = sim::Json::array({trial.missed.begin(), trial.missed.end()});
    return json;
}

void add_quality(const DropReport& report, sim::Json& json) {
    json[drop_key::kRestKineticEnergyJ] = report.rest.kinetic_energy;
    json[drop_key::kRestRmsSpeed] = report.rest.rms_speed;
    json[drop_key::kRestNetSpeed] = report.rest.net_speed;
    json[drop_key::kWeightlessEnergyGrowth] = report.weightless.energy_growth;
    json[drop_key::kWeightlessKineticGrowth] = report.weightless.kinetic_growth;
    json[drop_key::kConvergedSubsteps] = report.converged->substeps;
    json[drop_key::kDistanceMeanM] = report.converged->distance.mean;
    json[drop_key::kDistanceRmsM] = report.converged->distance.rms;
    json[drop_key::kNoiseFloorMeanM] = report.converged->noise_floor.mean;
    json[drop_key::kNoiseFloorRmsM] = report.converged->noise_floor.rms;
}

// Runs both variants alternately, so that other load on the machine affects both alike. The variant with contact
// samples is timed at least once; for the other, the search has a time already.
void time_drops(const SphereDropOptions& options, int repetitions, DropReport& report, const sim::Progress& progress) {
    SphereDropOptions sampled = options;
    sampled.has_contact_samples = true;
    std::vector<double> without, with;
    for (int i = 0; i < repetitions; ++i) {
        sim::report(progress, "timing", double(i) / repetitions);
        without.push_back(run_sphere_drop(options).ms_per_frame);
        with.push_back(run_sphere_drop(sampled).ms_per_frame);
    }
    if (with.empty()) with.push_back(run_sphere_drop(sampled).ms_per_frame);
    report.ms_per_frame = without.empty() ? report.chosen.ms_per_frame : sim::quantile(without, 0.5);
    report.ms_with_samples = sim::quantile(with, 0.5);
}

}  // namespace

DropReport measure_drop(const DropExperiment& experiment, const sim::Progress& progress) {
    DropReport report;
    const int base_quads = base_quads_for(experiment.triangles, experiment.scene);
    report.triangles = triangle_count(base_quads, experiment.scene.level);
    report.chosen = search(experiment, report.trials, progress);
    const SphereDropOptions options = options_for(experiment, report.chosen.substeps);
    time_drops(options, experiment.repetitions, report, progress);
    if (experiment.passes_quality_checks) measure_quality(options, report, progress);
    return report;
}

std::vector<Table> tables_of(const DropReport& report) {
    Table chosen{.name = "drop result", .title = "The cheapest setting that meets the gates"};
    if (!report.chosen.passes()) chosen.title = "No setting meets the gates; the last one tried";
    chosen.note = "Contact at the vertices; with samples: in the middle of triangles with an edge of 2 cm or more too.";
    chosen.columns = {"triangles",       "sub-steps",  "ms per frame", "us per triangle and frame",
                      "ms with samples", "p99 stretch"};
    chosen.add_row({report.triangles, report.chosen.substeps, Cell(report.ms_per_frame, 4),
                    Cell(1e3 * report.ms_per_frame / report.triangles, 5), Cell(report.ms_with_samples, 4),
                    Cell(report.chosen.quality.p99_stretch, 4)});
    std::vector<Table> tables{trial_table(report), chosen};
    if (report.converged) tables.push_back(quality_table(report));
    return tables;
}

sim::Json to_json(const DropReport& report) {
    sim::Json json = trial_json(report.chosen, report.ms_per_frame, report.triangles);
    json[drop_key::kMsWithSamples] = report.ms_with_samples;
    json[drop_key::kTriangles] = report.triangles;
    if (report.converged) add_quality(report, json);
    sim::Json& trials = json[drop_key::kTrials] = sim::Json::array();
    for (const DropTrial& trial : report.trials)
        trials.push_back(trial_json(trial, trial.ms_per_frame, report.triangles));
    return json;
}

}  // namespace selvedge::bench
