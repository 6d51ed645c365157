// Tables 3.7-3.10 and figures 3.21-3.22: squares refined everywhere and coarsened again, level by level.
#include <cmath>

#include "bench/thesis/pointer_mesh.h"
#include "bench/thesis/thesis.h"
#include "bench/timing.h"
#include "sim/adaptive/square.h"
#include "sim/adaptive/uniform.h"

namespace selvedge {
namespace {

constexpr std::size_t kLevels = 3;
constexpr std::size_t kRivals = 3;
constexpr std::array<const char*, kRivals> kRivalNames{"Selvedge", "pointers in pools", "pointers, new/delete"};

struct Counts {
    std::size_t vertices = 0, edges = 0, triangles = 0;  // of the whole hierarchy
};

// Seconds by rival, by level that is reached (refining) or left (coarsening).
using Samples = std::array<std::array<std::vector<double>, kLevels + 1>, kRivals>;

struct SquareRun {
    std::array<Counts, kLevels + 1> counts{};
    Samples refining, coarsening;

    double ms(const Samples& samples, std::size_t rival, std::size_t level) const {
        return 1e3 * timing_of(samples[rival][level]).median;
    }
    double total_ms(const Samples& samples, std::size_t rival) const {
        double sum = 0;
        for (std::size_t level = 1; level <= kLevels; ++level) sum += ms(samples, rival, level);
        return sum;
    }
    std::size_t triangles_made() const { return counts[kLevels].triangles - counts[0].triangles; }
};

// One way up and down again, each level timed.
template <class To>
void climb(To&& go_to, std::array<std::vector<double>, kLevels + 1>& refining,
           std::array<std::vector<double>, kLevels + 1>& coarsening) {
    for (std::size_t level = 1; level <= kLevels; ++level)
        refining[level].push_back(time_once([&] { go_to(static_cast<int>(level)); }));
    for (std::size_t level = kLevels; level > 0; --level)
        coarsening[level].push_back(time_once([&] { go_to(static_cast<int>(level) - 1); }));
}

template <class Store>
auto climber(PointerMesh<Store>& mesh) {
    return [&mesh](int level) { level > mesh.level() ? mesh.refine() : mesh.coarsen(); };
}

std::array<Counts, kLevels + 1> count_elements(AdaptiveMesh& mesh) {
    std::array<Counts, kLevels + 1> counts;
    NoState none;
    for (std::size_t level = 0; level <= kLevels; ++level) {
        set_uniform_level(mesh, none, static_cast<int>(level));
        counts[level] = {mesh.vertices().size(), mesh.edges().size(), mesh.triangles().size()};
    }
    set_uniform_level(mesh, none, 0);
    return counts;
}

// The rivals in turns; a first time unmeasured, so that pools and lists have their size.
SquareRun run_square(int quads, int runs) {
    const GarmentMesh base = make_square({.columns = quads, .rows = quads});
    AdaptiveMesh mesh(base);
    PointerMesh<Pools> pooled(base);
    PointerMesh<NewDelete> plain(base);
    NoState none;
    const auto ours = [&](int level) { set_uniform_level(mesh, none, level); };
    SquareRun run;
    run.counts = count_elements(mesh);
    Samples first, ignored;
    for (int i = 0; i <= runs; ++i) {
        Samples& refining = i == 0 ? first : run.refining;
        Samples& coarsening = i == 0 ? ignored : run.coarsening;
        climb(ours, refining[0], coarsening[0]);
        climb(climber(pooled), refining[1], coarsening[1]);
        climb(climber(plain), refining[2], coarsening[2]);
    }
    return run;
}

Table table_of(const std::string& name, const SquareRun& run) {
    Table table{
        .name = name,
        .title = "Uniform refinement and coarsening of " + std::to_string(run.counts[0].triangles) + " triangles",
        .note =
            "ms to reach a level from the one above it, and to leave it again; median of runs. The pointer "
            "meshes know S0 and S7 only and ask no criteria; Selvedge asks each edge and refreshes its "
            "leaf lists. Elements are those of the whole hierarchy.",
        .columns = {"level", "vertices", "edges", "triangles"}};
    for (const char* way : {"refine: ", "coarsen: "})
        for (const char* rival : kRivalNames) table.columns.push_back(std::string(way) + rival + ", ms");
    for (std::size_t level = 0; level <= kLevels; ++level) {
        const Counts& counts = run.counts[level];
        std::vector<Cell> row{level, counts.vertices, counts.edges, counts.triangles};
        for (const Samples* samples : {&run.refining, &run.coarsening})
            for (std::size_t rival = 0; rival < kRivals; ++rival)
                row.push_back(level == 0 ? Cell() : Cell(run.ms(*samples, rival, level), 4));
        table.add_row(std::move(row));
    }
    std::vector<Cell> totals{"all", Cell(), Cell(), Cell()};
    std::vector<Cell> each{"ns per triangle made", Cell(), Cell(), Cell()};
    for (const Samples* samples : {&run.refining, &run.coarsening}) {
        for (std::size_t rival = 0; rival < kRivals; ++rival) {
            const double ms = run.total_ms(*samples, rival);
            totals.push_back(Cell(ms, 4));
            each.push_back(Cell(1e6 * ms / static_cast<double>(run.triangles_made()), 1));
        }
    }
    table.add_row(std::move(totals));
    table.add_row(std::move(each));
    return table;
}

Figure figure_of(const std::string& name, const std::string& title, const std::vector<SquareRun>& runs,
                 Samples SquareRun::*samples) {
    Figure figure;
    figure.series = {.name = name, .title = title, .columns = {"base triangles"}};
    for (const char* rival : kRivalNames) figure.series.columns.push_back(std::string(rival) + ", ms");
    figure.y_label = "ms";
    figure.is_logarithmic = true;
    for (const SquareRun& run : runs) {
        std::vector<Cell> row{run.counts[0].triangles};
        for (std::size_t rival = 0; rival < kRivals; ++rival) row.push_back(Cell(run.total_ms(run.*samples, rival), 4));
        figure.series.add_row(std::move(row));
    }
    return figure;
}

}  // namespace

ThesisResult measure_uniform_refinement(const ThesisOptions& options) {
    const std::vector<int> quads = options.is_quick ? std::vector<int>{4, 8} : std::vector<int>{4, 8, 16, 32};
    ThesisResult result;
    std::vector<SquareRun> runs;
    for (std::size_t i = 0; i < quads.size(); ++i) {
        runs.push_back(run_square(quads[i], options.is_quick ? 1 : (quads[i] < 16 ? 41 : 11)));
        result.tables.push_back(table_of("3." + std::to_string(7 + i), runs.back()));
    }
    result.figures = {figure_of("3.21", "Uniform refinement from level 0 to 3", runs, &SquareRun::refining),
                      figure_of("3.22", "Uniform coarsening from level 3 to 0", runs, &SquareRun::coarsening)};
    return result;
}

}  // namespace selvedge
