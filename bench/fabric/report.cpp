#include "bench/fabric/report.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "bench/fabric/theory.h"
#include "sim/core/gravity.h"

namespace selvedge::bench {
namespace {

std::vector<sim::Fabric> fabrics_of(const FabricExperiment& experiment) {
    std::vector<std::string> names = experiment.fabrics;
    if (names.empty() && experiment.is_quick) names = {"silk", "wool_twill", "cotton_shirting", "denim"};
    if (names.empty()) names = sim::fabric_names();
    std::vector<sim::Fabric> fabrics;
    fabrics.reserve(names.size());
    for (const std::string& name : names) fabrics.push_back(sim::find_fabric(name));
    return fabrics;
}

std::string degrees(double angle) {
    return std::to_string(std::lround(angle * 180 / std::numbers::pi)) + " deg";
}

MeshSetting turned(MeshSetting mesh, double angle) {
    mesh.angle = angle;
    return mesh;
}

using Test = std::function<Reading(const sim::Fabric&, YarnDirection, const MeshSetting&, const Stepping&)>;

// Makes tables that have one column for each mesh angle, and counts gates.
struct TableMaker {
    const FabricExperiment& experiment;
    const sim::Progress& progress;
    FabricTables made{};

    Table& begin(Table table, std::vector<std::string> before, std::vector<std::string> after) {
        table.columns = std::move(before);
        for (const double angle : mesh_angles(experiment)) table.columns.push_back(degrees(angle));
        table.columns.insert(table.columns.end(), after.begin(), after.end());
        made.tables.push_back(std::move(table));
        return made.tables.back();
    }

    // Counts a row with a gate. Returns the text for the verdict column.
    std::string verdict(bool is_met, bool is_at_rest, const std::string& miss) {
        ++made.rows;
        if (!is_met) ++made.missed;
        return (is_met ? "met" : miss) + std::string(is_at_rest ? "" : ", not at rest");
    }

    void tell(const std::string& what, std::size_t done, std::size_t of) const {
        sim::report(progress, what, static_cast<double>(done) / static_cast<double>(of));
    }
};

// scale: factor from SI to the unit of the table.
void add_reading_row(TableMaker& maker, Table& table, const Test& test, const sim::Fabric& fabric,
                     YarnDirection direction, const MeshSetting& level, double scale) {
    std::vector<Cell> row{fabric.name, name_of(direction), level_name(level)};
    std::vector<Cell> measured;
    double worst = 0;
    bool is_at_rest = true;
    double expected = 0;
    for (const double angle : mesh_angles(maker.experiment)) {
        const Reading reading = test(fabric, direction, turned(level, angle), maker.experiment.stepping);
        measured.emplace_back(scale * reading.measured, 4);
        expected = reading.expected;
        is_at_rest = is_at_rest && reading.is_at_rest;
        if (!(std::abs(reading.error()) <= std::abs(worst))) worst = reading.error();
    }
    row.emplace_back(scale * expected, 4);
    row.insert(row.end(), measured.begin(), measured.end());
    row.emplace_back(100 * worst, 1);
    const double gate = allowed_error(level);
    row.push_back(gate < 0 ? Cell() : Cell(100 * gate, 0));
    const bool is_met = std::abs(worst) <= gate;
    row.push_back(gate < 0 ? Cell(is_at_rest ? "no gate" : "no gate, not at rest")
                           : Cell(maker.verdict(is_met, is_at_rest, "missed")));
    table.add_row(std::move(row));
}

void add_readings(TableMaker& maker, Table title, const Test& test, const std::vector<YarnDirection>& directions,
                  double scale) {
    const std::string name = title.name;
    Table& table = maker.begin(std::move(title), {"fabric", "direction", "level", "expected"},
                               {"worst error, %", "gate, %", "verdict"});
    const std::vector<sim::Fabric> fabrics = fabrics_of(maker.experiment);
    for (std::size_t i = 0; i < fabrics.size(); ++i) {
        for (const YarnDirection direction : directions) {
            maker.tell(name + ", " + fabrics[i].name, i, fabrics.size());
            for (const MeshSetting& level : level_settings(maker.experiment))
                add_reading_row(maker, table, test, fabrics[i], direction, level, scale);
        }
    }
}

void measure_cantilever(TableMaker& maker) {
    const Table title{.name = "cantilever",
                      .title = "Peirce's cantilever: bending rigidity, uN m",
                      .note =
                          "From the dip of a strip's chord by the exact elastica; the overhang is cut so that it "
                          "should be 41.5 degrees. Without internal friction."};
    add_readings(maker, title, test_cantilever, {YarnDirection::Warp, YarnDirection::Weft}, 1e6);
}

void measure_strip(TableMaker& maker) {
    const std::vector<YarnDirection> threads{YarnDirection::Warp, YarnDirection::Weft};
    add_readings(maker,
                 {.name = "strip by its own weight",
                  .title = "Hanging strip of 50 cm: strain by its own weight, parts per million",
                  .note = "Expected: w L / 2k."},
                 test_own_weight, threads, 1e6);
    add_readings(maker,
                 {.name = "loaded strip",
                  .title = "Hanging strip of 50 cm: strain by a weight at its end, %",
                  .note = "Weight of 19.6 or 4.9 N/m, or what strains it to half its limit."},
                 test_load, threads, 100);
}

void measure_bias(TableMaker& maker) {
    add_readings(maker,
                 {.name = "bias strip",
                  .title = "Strip cut at 45 degrees to the threads: strain by a weight at its end, %",
                  .note = "By the shear stiffness and the threads; read clear of the clamps. Without internal "
                          "friction."},
                 test_load, {YarnDirection::Bias}, 100);
}

void measure_swing(TableMaker& maker) {
    const auto test = [](const sim::Fabric& fabric, YarnDirection, const MeshSetting& mesh, const Stepping& stepping) {
        const Stepping fine{.substeps = 3 * stepping.substeps, .frame_seconds = stepping.frame_seconds};
        const double expected = swing_period(fabric, {.angle = mesh.angle, .level = 3}, fine);
        return Reading{.expected = expected, .measured = swing_period(fabric, mesh, stepping)};
    };
    add_readings(maker,
                 {.name = "swing",
                  .title = "Strip of 30 cm let go at 20 degrees: period, s",
                  .note = "Expected: level 3 with three times the sub-steps. A hanging chain's, for small swings, is "
                          "0.914 s."},
                 test, {YarnDirection::Warp}, 1);
}

// This table has an upper limit instead of expected values.
void measure_energy(TableMaker& maker) {
    constexpr double kRounding = 1e-3;
    Table& table = maker.begin(
        {.name = "energy",
         .title = "Strip of 30 cm let go level: most that kinetic and potential energy rise above the start, %",
         .note = "Of the work that its weight does over 30 cm. Never above nil, but for rounding: 0.1 %."},
        {"fabric", "level"}, {"verdict"});
    const std::vector<sim::Fabric> fabrics = fabrics_of(maker.experiment);
    for (std::size_t i = 0; i < fabrics.size(); ++i) {
        maker.tell("energy, " + fabrics[i].name, i, fabrics.size());
        for (const MeshSetting& level : level_settings(maker.experiment)) {
            std::vector<Cell> row{fabrics[i].name, level_name(level)};
            double worst = -1;
            for (const double angle : mesh_angles(maker.experiment)) {
                const double growth = energy_growth(fabrics[i], turned(level, angle), maker.experiment.stepping);
                row.emplace_back(100 * growth, 3);
                if (!(growth <= worst)) worst = growth;
            }
            row.emplace_back(maker.verdict(worst <= kRounding, true, "missed: it grew"));
            table.add_row(std::move(row));
        }
    }
}

// Drape coefficients of one fabric over all levels, for the comparison of fabrics.
struct DrapeOfFabric {
    std::string fabric;
    double least = 1e9;  // %, over the levels 1 to 3 and adaptive
    double most = -1e9;
    double sum = 0;
    int count = 0;
};

std::string drape_miss(double coefficient, double floor, const DrapeBand& band) {
    constexpr double kSlack = 1;  // percentage points
    if (coefficient < floor - kSlack) return "below the floor";
    if (band.high > 0 && coefficient < band.low) return "below the published range";
    if (band.high > 0 && coefficient > band.high) return "above the published range";
    return "";
}

void add_drape_row(TableMaker& maker, Table& table, const sim::Fabric& fabric, const MeshSetting& level,
                   DrapeOfFabric& total) {
    const double rigidity = (fabric.bending_warp + fabric.bending_weft) / 2;
    const double floor = drape_floor(std::cbrt(rigidity / (sim::kGravity * fabric.area_density)));
    const DrapeBand band = published_drape(fabric.name);
    std::vector<Cell> row{fabric.name, level_name(level), Cell(floor, 1)};
    row.push_back(band.high > 0
                      ? Cell(std::to_string(std::lround(band.low)) + "-" + std::to_string(std::lround(band.high)))
                      : Cell());
    std::string folds;
    std::string miss;
    bool is_at_rest = true;
    for (const double angle : mesh_angles(maker.experiment)) {
        const DrapeReading reading = test_drape(fabric, turned(level, angle), maker.experiment.stepping);
        row.emplace_back(reading.coefficient, 1);
        folds += (folds.empty() ? "" : " ") + std::to_string(reading.folds);
        if (miss.empty()) miss = drape_miss(reading.coefficient, floor, band);
        is_at_rest = is_at_rest && reading.is_at_rest;
        if (level.level == 0) continue;
        total.least = std::min(total.least, reading.coefficient);
        total.most = std::max(total.most, reading.coefficient);
        total.sum += reading.coefficient;
        ++total.count;
    }
    row.emplace_back(folds);
    row.emplace_back(level.level == 0 ? "no gate" : maker.verdict(miss.empty(), is_at_rest, miss));
    table.add_row(std::move(row));
}

void add_drape_comparison(TableMaker& maker, const std::vector<DrapeOfFabric>& fabrics) {
    constexpr double kSpread = 5;  // percentage points
    Table table{.name = "drape, compared",
                .title = "Drape coefficients over levels 1 to 3 and adaptive, %",
                .note = "Levels should differ by 5 points at most, and silk < wool_twill < cotton_shirting < denim."};
    table.columns = {"fabric", "mean", "spread, points", "verdict"};
    const std::vector<std::string> order{"silk", "wool_twill", "cotton_shirting", "denim"};
    for (const DrapeOfFabric& f : fabrics) {
        const double mean = f.sum / f.count;
        std::string miss = f.most - f.least > kSpread ? "levels differ" : "";
        const auto place = std::ranges::find(order, f.fabric);
        for (const DrapeOfFabric& other : fabrics) {
            const auto other_place = std::ranges::find(order, other.fabric);
            const bool is_softer = place != order.end() && other_place != order.end() && other_place < place;
            if (is_softer && other.sum / other.count >= mean)
                miss += (miss.empty() ? "" : ", ") + ("not above " + other.fabric);
        }
        table.add_row({f.fabric, Cell(mean, 1), Cell(f.most - f.least, 1), maker.verdict(miss.empty(), true, miss)});
    }
    maker.made.tables.push_back(std::move(table));
}

void measure_drape(TableMaker& maker) {
    Table& table = maker.begin({.name = "drape",
                                .title = "Cusick's drape coefficient, %, of 30 cm on 18 cm, with internal friction",
                                .note = "Floor: radial strips, each free of its neighbours. Folds at each angle."},
                               {"fabric", "level", "floor", "published"}, {"folds", "verdict"});
    std::vector<DrapeOfFabric> totals;
    const std::vector<sim::Fabric> fabrics = fabrics_of(maker.experiment);
    for (std::size_t i = 0; i < fabrics.size(); ++i) {
        totals.push_back({.fabric = fabrics[i].name});
        for (const MeshSetting& level : level_settings(maker.experiment)) {
            maker.tell("drape, " + fabrics[i].name, i, fabrics.size());
            add_drape_row(maker, table, fabrics[i], level, totals.back());
        }
    }
    add_drape_comparison(maker, totals);
}

}  // namespace

FabricTables measure_fabrics(const std::string& test, const FabricExperiment& experiment,
                             const sim::Progress& progress) {
    TableMaker maker{experiment, progress};
    if (test == "cantilever") measure_cantilever(maker);
    if (test == "strip") measure_strip(maker);
    if (test == "bias") measure_bias(maker);
    if (test == "drape") measure_drape(maker);
    if (test == "swing") measure_swing(maker);
    if (test == "energy") measure_energy(maker);
    return std::move(maker.made);
}

}  // namespace selvedge::bench
