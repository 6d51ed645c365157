// The experiments on the adaptive mesh: tables 3.11 (memory), 3.2-3.5 (cost of transitions) and 3.7-3.10 with figures
// 3.21-3.22 (uniform refinement).
#include <array>
#include <cmath>
#include <map>

#include "bench/support/cloth_run.h"
#include "bench/support/measured_mesh.h"
#include "bench/thesis/pointer_mesh.h"
#include "bench/thesis/pointer_transitions.h"
#include "bench/thesis/thesis.h"
#include "bench/thesis/thesis_drop.h"
#include "sim/adaptive/criteria.h"
#include "sim/cloth/cloth.h"
#include "sim/mesh/square.h"

namespace selvedge::bench {
namespace {

constexpr sim::AdaptiveMesh::BytesPerElement kBytes = sim::AdaptiveMesh::bytes_per_element();
constexpr std::size_t kThesisVertex = 144, kThesisEdge = 52, kThesisTriangle = 120;

// Bytes of one vertex in the state arrays of the cloth: x, x_prev, inverse mass and normal.
constexpr std::size_t kClothBytes = 2 * sizeof(Vec4f) + sizeof(float) + sizeof(Vec3f);

template <class T>
std::size_t bytes_of(const std::vector<T>& list) {
    return list.size() * sizeof(T);
}

std::size_t list_bytes(const sim::LeafLists& leaves) {
    return bytes_of(leaves.vertices) + bytes_of(leaves.edges) + bytes_of(leaves.triangles) + bytes_of(leaves.hinges);
}

void add_elements(Table& table) {
    table.add_row({"one element", Cell(), kBytes.vertex, kBytes.edge, kBytes.triangle, Cell(), Cell(), Cell(), Cell()});
    table.add_row({"one element, the thesis", Cell(), kThesisVertex, kThesisEdge, kThesisTriangle, Cell(), Cell(),
                   Cell(), Cell()});
}

void add_hierarchy(Table& table, sim::AdaptiveMesh& mesh, int level) {
    sim::NoState none;
    set_uniform_level(mesh, none, level);
    const std::size_t vertices = mesh.vertices().size(), edges = mesh.edges().size(),
                      triangles = mesh.triangles().size();
    const std::size_t ours = vertices * kBytes.vertex + edges * kBytes.edge + triangles * kBytes.triangle;
    const std::size_t thesis = vertices * kThesisVertex + edges * kThesisEdge + triangles * kThesisTriangle;
    table.add_row({std::to_string(mesh.base_triangle_count()) + " triangles", level, vertices * kBytes.vertex,
                   edges * kBytes.edge, triangles * kBytes.triangle, ours, thesis, list_bytes(mesh.leaves()),
                   vertices * kClothBytes});
}

}  // namespace

ThesisResult measure_memory(const ThesisOptions& options) {
    Table table{
        .name = "3.11",
        .title = "Memory, bytes",
        .note =
            "Elements alive: adjacency, corner coordinates, areas and places in lists and pools counted (64-bit "
            "build). The thesis' figures (32-bit pointers) are for the same elements. Leaf lists and the "
            "cloth's positions, velocities, masses and normals come on top.",
        .columns = {"mesh", "level", "vertices", "edges", "triangles", "together", "the thesis' elements", "leaf lists",
                    "cloth's state"}};
    add_elements(table);
    for (const int quads : options.is_quick ? std::vector<int>{4} : std::vector<int>{4, 8, 16, 32}) {
        sim::AdaptiveMesh mesh(sim::make_square({.columns = quads, .rows = quads}));
        for (int level = 0; level <= mesh.max_level(); ++level) add_hierarchy(table, mesh, level);
    }
    ThesisResult result;
    result.tables = {table};
    const bool is_less =
        kBytes.vertex < kThesisVertex && kBytes.edge < kThesisEdge && kBytes.triangle < kThesisTriangle;
    result.trends = {{.item = "T3.11",
                      .reported = "144, 52 and 120 bytes per vertex, edge and triangle with 32-bit pointers.",
                      .measured = std::to_string(kBytes.vertex) + ", " + std::to_string(kBytes.edge) + " and " +
                                  std::to_string(kBytes.triangle) +
                                  " bytes in a 64-bit build: " + (is_less ? "less" : "not less") + " for each.",
                      .agrees = is_less}};
    return result;
}

// Tables 3.2-3.5: the cost of one transition of one triangle, direct and indirect (via C0).

namespace {

using Matrix = std::array<std::array<double, sim::kConfigurations>, sim::kConfigurations>;  // us, by (from, to)

// A mesh of base triangles whose edges are all split, so that each triangle can take any configuration.
class TestBed {
 public:
    explicit TestBed(int quads) : mesh_(sim::make_square({.columns = quads, .rows = quads}), {.max_level = 1}) {
        const std::vector<sim::EdgeId> edges(mesh_.unsplit_edges(0).begin(), mesh_.unsplit_edges(0).end());
        for (const sim::EdgeId e : edges) mesh_.split(e);
    }

    std::size_t size() const { return mesh_.base_triangle_count(); }

    void change_all(sim::Configuration to) {
        for (std::uint32_t t = 0; t < size(); ++t) mesh_.change_configuration(sim::TriangleId(t), to);
    }
    void change_all_by_c0(sim::Configuration to) {
        for (std::uint32_t t = 0; t < size(); ++t) {
            mesh_.change_configuration(sim::TriangleId(t), sim::Configuration::C0);
            mesh_.change_configuration(sim::TriangleId(t), to);
        }
    }

 private:
    sim::AdaptiveMesh mesh_;
};

struct Costs {
    Matrix direct{};
    Matrix indirect{};
};

template <class F>
void for_each_pair(F&& f) {
    for (std::size_t from = 0; from < sim::kConfigurations; ++from) {
        for (std::size_t to = 0; to < sim::kConfigurations; ++to) {
            if (from != to) f(from, to);
        }
    }
}

// Measures all pairs in turn, direct and indirect, and begins again: so a slow moment of the machine falls on one
// sample of many pairs, which their medians leave out, not on all samples of one.
Costs measure(const ThesisOptions& options) {
    TestBed bed(options.is_quick ? 2 : 16);
    std::array<std::array<std::vector<double>, sim::kConfigurations>, sim::kConfigurations> direct, indirect;
    for (int i = 0; i < (options.is_quick ? 1 : 21); ++i) {
        for_each_pair([&](std::size_t from, std::size_t to) {
            const auto start = static_cast<sim::Configuration>(from), end = static_cast<sim::Configuration>(to);
            bed.change_all(start);
            direct[from][to].push_back(time_once([&] { bed.change_all(end); }));
            bed.change_all(start);
            indirect[from][to].push_back(time_once([&] { bed.change_all_by_c0(end); }));
        });
    }
    Costs costs;
    const double us = 1e6 / static_cast<double>(bed.size());
    for_each_pair([&](std::size_t from, std::size_t to) {
        costs.direct[from][to] = us * timing_of(direct[from][to]).median;
        costs.indirect[from][to] = us * timing_of(indirect[from][to]).median;
    });
    return costs;
}

std::string configuration_name(std::size_t configuration) {
    return "C" + std::to_string(configuration);
}

// us, by configuration, on the thesis' structure.
struct ClearCosts {
    std::array<double, sim::kConfigurations> clear{}, configure{};
};

ClearCosts measure_clearing(const ThesisOptions& options) {
    PointerTransitions bed(sim::make_square({.columns = options.is_quick ? 2 : 16, .rows = options.is_quick ? 2 : 16}));
    std::array<std::vector<double>, sim::kConfigurations> clearing, configuring;
    for (int i = 0; i < (options.is_quick ? 1 : 41); ++i) {
        for (std::size_t c = 0; c < sim::kConfigurations; ++c) {
            const auto configuration = static_cast<sim::Configuration>(c);
            configuring[c].push_back(time_once([&] { bed.configure_all(configuration); }));
            clearing[c].push_back(time_once([&] { bed.clear_all(); }));
        }
    }
    const double us = 1e6 / static_cast<double>(bed.size());
    ClearCosts costs;
    for (std::size_t c = 0; c < sim::kConfigurations; ++c) {
        costs.clear[c] = us * timing_of(clearing[c]).median;
        costs.configure[c] = us * timing_of(configuring[c]).median;
    }
    return costs;
}

Table clear_table(const Costs& costs, const ClearCosts& pointers) {
    Table table{.name = "3.2",
                .title = "Clearing a configuration to the cleared state SC, and configuring it back",
                .note =
                    "us per triangle: median of runs over many triangles that are all changed. SC: a triangle without "
                    "internal elements that is no leaf either. Selvedge stores no adjacency in vertices and lists "
                    "leaves lazily, so its SC is C0, and C0 costs nothing. The thesis' structure (pointers, elements "
                    "from pools, up to 20 adjacent triangles listed in each vertex) follows here the same layouts.",
                .columns = {"configuration", "Selvedge: clear, us", "Selvedge: configure, us", "pointers: clear, us",
                            "pointers: configure, us"}};
    for (std::size_t c = 0; c < sim::kConfigurations; ++c)
        table.add_row({configuration_name(c), c == 0 ? Cell(0.0, 3) : Cell(costs.direct[c][0], 3),
                       c == 0 ? Cell(0.0, 3) : Cell(costs.direct[0][c], 3), Cell(pointers.clear[c], 3),
                       Cell(pointers.configure[c], 3)});
    return table;
}

Table matrix_table(const Matrix& values, const std::string& name, const std::string& title, int decimals) {
    Table table{.name = name, .title = title, .note = "Rows: from. Columns: to.", .columns = {"from"}};
    for (std::size_t to = 0; to < sim::kConfigurations; ++to) table.columns.push_back(configuration_name(to));
    for (std::size_t from = 0; from < sim::kConfigurations; ++from) {
        std::vector<Cell> row{configuration_name(from)};
        for (std::size_t to = 0; to < sim::kConfigurations; ++to)
            row.push_back(from == to ? Cell() : Cell(values[from][to], decimals));
        table.add_row(std::move(row));
    }
    return table;
}

Matrix ratio(const Costs& costs) {
    Matrix percent{};
    for_each_pair([&](std::size_t from, std::size_t to) {
        percent[from][to] = 100 * costs.direct[from][to] / costs.indirect[from][to];
    });
    return percent;
}

// Weighted sums over pairs of configurations.
struct WeightedMean {
    double direct = 0, indirect = 0, weight = 0;

    void add(const Costs& costs, std::size_t from, std::size_t to, double w) {
        direct += w * costs.direct[from][to];
        indirect += w * costs.indirect[from][to];
        weight += w;
    }
};

void add_mean(Table& table, const std::string& what, const WeightedMean& mean) {
    const double w = mean.weight > 0 ? mean.weight : 1;
    table.add_row({what, Cell(mean.direct / w, 4), Cell(mean.indirect / w, 4),
                   Cell(100 * mean.direct / mean.indirect, 1), Cell(), Cell(), Cell()});
}

Table means_table(const Costs& costs, const sim::TransitionCounts& recorded) {
    Table table{.name = "3.2-3.5",
                .title = "Means of tables 3.2-3.5, and the one pair that the thesis gives",
                .note =
                    "Recorded: weighted by how often each transition was made when a cloth with criteria A and B "
                    "was dropped on a sphere.",
                .columns = {"transition", "direct, us", "indirect, us", "ratio, %", "thesis direct, us",
                            "thesis indirect, us", "thesis ratio, %"}};
    table.add_row({"C1 to C2", Cell(costs.direct[1][2], 4), Cell(costs.indirect[1][2], 4),
                   Cell(100 * costs.direct[1][2] / costs.indirect[1][2], 1), Cell(0.145, 3), Cell(0.246, 3),
                   Cell(58.8, 1)});
    WeightedMean all, inner, seen;
    for_each_pair([&](std::size_t from, std::size_t to) {
        all.add(costs, from, to, 1);
        if (from != 0 && to != 0) inner.add(costs, from, to, 1);
        seen.add(costs, from, to, static_cast<double>(recorded.by_configuration[from][to]));
    });
    add_mean(table, "mean of all 110", all);
    add_mean(table, "mean of the 90 without C0", inner);
    add_mean(table, "mean of the recorded", seen);
    return table;
}

}  // namespace

ThesisResult measure_transition_cost(const ThesisOptions& options) {
    const Costs costs = measure(options);
    const ThesisDropRun drop = run_thesis_drop({.object = ThesisDropObject::Sphere,
                                                .criteria = {.collision = true, .curvature = true, .length = false},
                                                .seconds = options.is_quick ? 0.4 : 2.0});
    ThesisResult result;
    const double pair = 100 * costs.direct[1][2] / costs.indirect[1][2];
    WeightedMean all;
    for_each_pair([&](std::size_t from, std::size_t to) { all.add(costs, from, to, 1); });
    const double mean = 100 * all.direct / all.indirect;
    result.trends = {{.item = "T3.5",
                      .reported = "direct transitions cost less: C1 to C2 58.8 % of the indirect one.",
                      .measured = "C1 to C2 " + Cell(pair, 1).to_text() + " %, and all pairs in the mean " +
                                  Cell(mean, 1).to_text() + " %.",
                      .agrees = pair < 100 && mean < 100}};
    result.tables = {clear_table(costs, measure_clearing(options)),
                     matrix_table(costs.indirect, "3.3", "Indirect transitions, by way of C0, us", 3),
                     matrix_table(costs.direct, "3.4", "Direct transitions, us", 3),
                     matrix_table(ratio(costs), "3.5", "Direct transitions as a share of indirect ones, %", 1),
                     means_table(costs, drop.transitions)};
    return result;
}

// Tables 3.7-3.10 and figures 3.21-3.22: squares refined uniformly and coarsened again, level by level.

namespace {

constexpr std::size_t kLevels = 3;
constexpr std::size_t kBaselines = 4;
constexpr std::array<const char*, kBaselines> kBaselineNames{"Selvedge", "pools", "new/delete", "list-based pools"};
constexpr std::size_t kPooled = 1, kPlain = 2;

struct Counts {
    std::size_t vertices = 0, edges = 0, triangles = 0;  // of the whole hierarchy
};

// Seconds, by baseline and by the level that is reached (refining) or left (coarsening).
using Samples = std::array<std::array<std::vector<double>, kLevels + 1>, kBaselines>;

struct SquareRun {
    std::array<Counts, kLevels + 1> counts{};
    Samples refining, coarsening;

    double ms(const Samples& samples, std::size_t baseline, std::size_t level) const {
        return 1e3 * timing_of(samples[baseline][level]).median;
    }
    double total_ms(const Samples& samples, std::size_t baseline) const {
        double sum = 0;
        for (std::size_t level = 1; level <= kLevels; ++level) sum += ms(samples, baseline, level);
        return sum;
    }
    std::size_t triangles_made() const { return counts[kLevels].triangles - counts[0].triangles; }
};

// Refines from level 0 to kLevels and coarsens back; times each level.
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

std::array<Counts, kLevels + 1> count_elements(sim::AdaptiveMesh& mesh) {
    std::array<Counts, kLevels + 1> counts;
    sim::NoState none;
    for (std::size_t level = 0; level <= kLevels; ++level) {
        set_uniform_level(mesh, none, static_cast<int>(level));
        counts[level] = {mesh.vertices().size(), mesh.edges().size(), mesh.triangles().size()};
    }
    set_uniform_level(mesh, none, 0);
    return counts;
}

// The C library merges small freed blocks when a large one is next asked for. Asks for one, so that this is not timed
// with the baseline that follows new and delete.
void settle_heap() {
    keep(std::vector<char>(std::size_t{1} << 17U));
}

// Runs the baselines alternately. The first run is not measured: it lets pools and lists grow to their full size.
SquareRun run_square(int quads, int runs) {
    const sim::GarmentMesh base = sim::make_square({.columns = quads, .rows = quads});
    sim::AdaptiveMesh mesh(base);
    PointerMesh<Pools> pooled(base);
    PointerMesh<NewDelete> plain(base);
    PointerMesh<ListPools> listed(base);
    sim::NoState none;
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
        settle_heap();
        climb(climber(listed), refining[3], coarsening[3]);
    }
    return run;
}

Table table_of(const std::string& name, const SquareRun& run) {
    Table table{
        .name = name,
        .title = "Uniform refinement and coarsening of " + std::to_string(run.counts[0].triangles) + " triangles",
        .note =
            "ms to reach a level from the one above it, and to leave it again; CPU time of one thread, median of runs. "
            "The thesis' structure (elements linked by pointers) is allocated from memory pools, by new and delete, "
            "and from list-based pools; it knows S0 and S7 only and asks no criteria. Selvedge asks each edge and "
            "refreshes its leaf lists. Elements are those of the whole hierarchy.",
        .columns = {"level", "vertices", "edges", "triangles"}};
    for (const char* way : {"refine: ", "coarsen: "})
        for (const char* baseline : kBaselineNames) table.columns.push_back(std::string(way) + baseline + ", ms");
    for (std::size_t level = 0; level <= kLevels; ++level) {
        const Counts& counts = run.counts[level];
        std::vector<Cell> row{level, counts.vertices, counts.edges, counts.triangles};
        for (const Samples* samples : {&run.refining, &run.coarsening})
            for (std::size_t baseline = 0; baseline < kBaselines; ++baseline)
                row.push_back(level == 0 ? Cell() : Cell(run.ms(*samples, baseline, level), 4));
        table.add_row(std::move(row));
    }
    std::vector<Cell> totals{"all", Cell(), Cell(), Cell()};
    std::vector<Cell> each{"ns per triangle made", Cell(), Cell(), Cell()};
    for (const Samples* samples : {&run.refining, &run.coarsening}) {
        for (std::size_t baseline = 0; baseline < kBaselines; ++baseline) {
            const double ms = run.total_ms(*samples, baseline);
            totals.push_back(Cell(ms, 4));
            each.push_back(Cell(1e6 * ms / static_cast<double>(run.triangles_made()), 1));
        }
    }
    table.add_row(std::move(totals));
    table.add_row(std::move(each));
    return table;
}

// Leaf triangles at a level.
std::size_t leaves_at(const SquareRun& run, std::size_t level) {
    return run.counts[0].triangles << (2 * level);
}

// us per existing triangle, by the number of existing triangles. Where several squares have the same number at other
// levels, their mean.
Figure figure_of(const std::string& name, const std::string& title, const std::vector<SquareRun>& runs,
                 Samples SquareRun::*samples) {
    const bool refines = samples == &SquareRun::refining;
    struct Sum {
        std::array<double, kBaselines> us{};
        double count = 0;
    };
    std::map<std::size_t, Sum> sums;
    for (const SquareRun& run : runs) {
        for (std::size_t level = 1; level <= kLevels; ++level) {
            const std::size_t existing = leaves_at(run, refines ? level - 1 : level);
            Sum& sum = sums[existing];
            ++sum.count;
            for (std::size_t baseline = 0; baseline < kBaselines; ++baseline)
                sum.us[baseline] += 1e3 * run.ms(run.*samples, baseline, level) / static_cast<double>(existing);
        }
    }
    Figure figure;
    figure.series = {.name = name,
                     .title = title,
                     .note = "us per triangle that exists before, over their number. Measured as tables 3.7 to 3.10.",
                     .columns = {"existing triangles"}};
    for (const char* baseline : kBaselineNames) figure.series.columns.push_back(std::string(baseline) + ", us");
    figure.y_label = "us per existing triangle";
    figure.is_logarithmic = true;
    for (const auto& [existing, sum] : sums) {
        std::vector<Cell> row{existing};
        for (const double us : sum.us) row.push_back(Cell(us / sum.count, 4));
        figure.series.add_row(std::move(row));
    }
    return figure;
}

// Whether pools are faster than new and delete, over all squares and levels.
Trend pool_trend(const std::string& item, const std::vector<SquareRun>& runs, Samples SquareRun::*samples) {
    double pooled = 0, plain = 0;
    for (const SquareRun& run : runs) {
        pooled += run.total_ms(run.*samples, kPooled);
        plain += run.total_ms(run.*samples, kPlain);
    }
    return {.item = item,
            .reported = "pools are meant to cost less than new and delete.",
            .measured = "with pools " + Cell(100 * pooled / plain, 0).to_text() + " % of the time with new and delete.",
            .agrees = pooled < plain};
}

Trend table_trend(const std::string& name, const SquareRun& run) {
    const double pooled = run.total_ms(run.refining, kPooled) + run.total_ms(run.coarsening, kPooled);
    const double plain = run.total_ms(run.refining, kPlain) + run.total_ms(run.coarsening, kPlain);
    return {.item = "T" + name,
            .reported = "pools are meant to cost less than new and delete.",
            .measured =
                "both together take " + Cell(100 * pooled / plain, 0).to_text() + " % of the time with new and delete.",
            .agrees = pooled < plain};
}

}  // namespace

ThesisResult measure_uniform_refinement(const ThesisOptions& options) {
    const std::vector<int> quads{4, 8, 16, 32};
    ThesisResult result;
    std::vector<SquareRun> runs;
    for (std::size_t i = 0; i < quads.size(); ++i) {
        runs.push_back(run_square(quads[i], options.is_quick ? 1 : (quads[i] < 16 ? 41 : 11)));
        const std::string name = "3." + std::to_string(7 + i);
        result.tables.push_back(table_of(name, runs.back()));
        result.trends.push_back(table_trend(name, runs.back()));
    }
    result.figures = {figure_of("3.21", "The cost of uniform refinement by one level", runs, &SquareRun::refining),
                      figure_of("3.22", "The cost of uniform coarsening by one level", runs, &SquareRun::coarsening)};
    result.trends.push_back(pool_trend("F3.21", runs, &SquareRun::refining));
    result.trends.push_back(pool_trend("F3.22", runs, &SquareRun::coarsening));
    return result;
}

}  // namespace selvedge::bench
