// The experiments on the adaptive mesh: tables 3.11 (memory), 3.6 (traversal), 3.2-3.5 (cost of transitions) and
// 3.7-3.10 with figures 3.21-3.22 (uniform refinement); figure 3.9 (choice of diagonal).
#include <array>
#include <cmath>

#include "bench/support/cloth_run.h"
#include "bench/support/measured_mesh.h"
#include "bench/thesis/pointer_mesh.h"
#include "bench/thesis/thesis.h"
#include "bench/thesis/thesis_drop.h"
#include "sim/adaptive/criteria.h"
#include "sim/cloth/cloth.h"

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
        sim::AdaptiveMesh mesh(make_square({.columns = quads, .rows = quads}));
        for (int level = 0; level <= mesh.max_level(); ++level) add_hierarchy(table, mesh, level);
    }
    ThesisResult result;
    result.tables = {table};
    return result;
}

// Table 3.6: traversal of all leaves by recursion through the hierarchy, and by flat lists.

namespace {

// The work at each leaf is small and the same for both traversals: a sum of rest lengths or areas.
struct Sums {
    double edges = 0;      // of rest lengths, m
    double triangles = 0;  // of material areas, m^2
    long edge_count = 0;
    long triangle_count = 0;

    void add_edge(float rest_length) {
        edges += static_cast<double>(rest_length);
        ++edge_count;
    }
    void add_triangle(const std::array<Vec2f, 3>& u) {
        triangles += static_cast<double>(sim::material_area(u));
        ++triangle_count;
    }
};

void visit_edge(const sim::AdaptiveMesh& mesh, sim::EdgeId id, Sums& sums) {
    const sim::AdaptiveEdge& edge = mesh.edge(id);
    if (!edge.centre) return sums.add_edge(edge.rest_length);
    for (const sim::EdgeId child : edge.children) visit_edge(mesh, child, sums);
}

void visit_triangle_edges(const sim::AdaptiveMesh& mesh, sim::TriangleId id, Sums& sums) {
    const sim::AdaptiveTriangle& t = mesh.triangle(id);
    if (is_leaf(t)) return;
    const sim::Layout& inside = layout(t.configuration);
    for (std::size_t i = 0; i < inside.edge_count; ++i) visit_edge(mesh, t.internal_edges[i], sums);
    for (std::size_t i = 0; i < inside.triangle_count; ++i) visit_triangle_edges(mesh, t.internal_triangles[i], sums);
}

void visit_triangle(const sim::AdaptiveMesh& mesh, sim::TriangleId id, Sums& sums) {
    const sim::AdaptiveTriangle& t = mesh.triangle(id);
    if (is_leaf(t)) return sums.add_triangle(t.u);
    for (std::size_t i = 0; i < layout(t.configuration).triangle_count; ++i)
        visit_triangle(mesh, t.internal_triangles[i], sums);
}

Sums edges_by_recursion(const sim::AdaptiveMesh& mesh) {
    Sums sums;
    for (std::uint32_t e = 0; e < mesh.base_edge_count(); ++e) visit_edge(mesh, sim::EdgeId(e), sums);
    for (std::uint32_t t = 0; t < mesh.base_triangle_count(); ++t) visit_triangle_edges(mesh, sim::TriangleId(t), sums);
    return sums;
}

Sums triangles_by_recursion(const sim::AdaptiveMesh& mesh) {
    Sums sums;
    for (std::uint32_t t = 0; t < mesh.base_triangle_count(); ++t) visit_triangle(mesh, sim::TriangleId(t), sums);
    return sums;
}

Sums edges_by_list(const sim::AdaptiveMesh& mesh) {
    Sums sums;
    for (const sim::LeafEdge& edge : mesh.leaf_edges()) sums.add_edge(edge.rest_length);
    return sums;
}

Sums triangles_by_list(const sim::AdaptiveMesh& mesh) {
    Sums sums;
    for (const sim::LeafTriangle& t : mesh.leaf_triangles()) sums.add_triangle(t.u);
    return sums;
}

// Median times of recursion and list, us; the two run alternately.
template <class Recursion, class List>
std::array<double, 2> compare(const sim::AdaptiveMesh& mesh, int runs, Recursion&& recursion, List&& list) {
    std::vector<double> by_recursion, by_list;
    for (int i = 0; i < runs; ++i) {
        by_recursion.push_back(time_once([&] { keep(recursion(mesh)); }));
        by_list.push_back(time_once([&] { keep(list(mesh)); }));
    }
    return {1e6 * timing_of(by_recursion).median, 1e6 * timing_of(by_list).median};
}

}  // namespace

ThesisResult measure_traversal(const ThesisOptions& options) {
    sim::AdaptiveMesh mesh(make_square({.columns = 8, .rows = 8}));
    sim::NoState none;
    Table table{.name = "3.6",
                .title = "Reaching all leaves: recursion through the hierarchy against flat lists",
                .note =
                    "Base mesh of 128 triangles, the same level everywhere. At each leaf a rest length or an area "
                    "is summed. us, median of runs.",
                .columns = {"level", "leaf edges", "edges by recursion, us", "edges by list, us",
                            "edges: recursion / list", "leaf triangles", "triangles by recursion, us",
                            "triangles by list, us", "triangles: recursion / list"}};
    const int runs = options.is_quick ? 1 : 101;
    for (int level = 0; level <= mesh.max_level(); ++level) {
        set_uniform_level(mesh, none, level);
        const auto edges = compare(mesh, runs, edges_by_recursion, edges_by_list);
        const auto triangles = compare(mesh, runs, triangles_by_recursion, triangles_by_list);
        SELVEDGE_ASSERT(edges_by_recursion(mesh).edge_count == edges_by_list(mesh).edge_count);
        table.add_row({level, edges_by_recursion(mesh).edge_count, Cell(edges[0], 2), Cell(edges[1], 2),
                       Cell(edges[0] / edges[1], 1), triangles_by_recursion(mesh).triangle_count, Cell(triangles[0], 2),
                       Cell(triangles[1], 2), Cell(triangles[0] / triangles[1], 1)});
    }
    ThesisResult result;
    result.tables = {table};
    return result;
}

// Tables 3.2-3.5: the cost of one transition of one triangle, direct and indirect (via C0).

namespace {

using Matrix = std::array<std::array<double, sim::kConfigurations>, sim::kConfigurations>;  // us, by (from, to)

// A mesh of base triangles whose edges are all split, so that each triangle can take any configuration.
class TestBed {
 public:
    explicit TestBed(int quads) : mesh_(make_square({.columns = quads, .rows = quads}), {.max_level = 1}) {
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

// Measures direct and indirect transitions alternately.
Costs measure(const ThesisOptions& options) {
    TestBed bed(options.is_quick ? 2 : 16);
    Costs costs;
    const int runs = options.is_quick ? 1 : 21;
    for_each_pair([&](std::size_t from, std::size_t to) {
        const auto start = static_cast<sim::Configuration>(from), end = static_cast<sim::Configuration>(to);
        std::vector<double> direct, indirect;
        for (int i = 0; i < runs; ++i) {
            bed.change_all(start);
            direct.push_back(time_once([&] { bed.change_all(end); }));
            bed.change_all(start);
            indirect.push_back(time_once([&] { bed.change_all_by_c0(end); }));
        }
        const double us = 1e6 / static_cast<double>(bed.size());
        costs.direct[from][to] = us * timing_of(direct).median;
        costs.indirect[from][to] = us * timing_of(indirect).median;
    });
    return costs;
}

std::string name_of(std::size_t configuration) {
    return "C" + std::to_string(configuration);
}

Table clear_table(const Costs& costs) {
    Table table{
        .name = "3.2",
        .title = "Clearing a configuration and configuring from C0",
        .note = "us of one transition of one triangle: median of runs over many triangles that are all changed.",
        .columns = {"configuration", "clearing to C0, us", "configuring from C0, us"}};
    for (std::size_t c = 1; c < sim::kConfigurations; ++c)
        table.add_row({name_of(c), Cell(costs.direct[c][0], 3), Cell(costs.direct[0][c], 3)});
    return table;
}

Table matrix_table(const Matrix& values, const std::string& name, const std::string& title, int decimals) {
    Table table{.name = name, .title = title, .note = "Rows: from. Columns: to.", .columns = {"from"}};
    for (std::size_t to = 0; to < sim::kConfigurations; ++to) table.columns.push_back(name_of(to));
    for (std::size_t from = 0; from < sim::kConfigurations; ++from) {
        std::vector<Cell> row{name_of(from)};
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
    result.tables = {clear_table(costs),
                     matrix_table(costs.indirect, "3.3", "Indirect transitions, by way of C0, us", 3),
                     matrix_table(costs.direct, "3.4", "Direct transitions, us", 3),
                     matrix_table(ratio(costs), "3.5", "Direct transitions as a share of indirect ones, %", 1),
                     means_table(costs, drop.transitions)};
    return result;
}

// Tables 3.7-3.10 and figures 3.21-3.22: squares refined uniformly and coarsened again, level by level.

namespace {

constexpr std::size_t kLevels = 3;
constexpr std::size_t kBaselines = 3;
constexpr std::array<const char*, kBaselines> kBaselineNames{"Selvedge", "pointers in pools", "pointers, new/delete"};

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

// Runs the baselines alternately. The first run is not measured: it lets pools and lists grow to their full size.
SquareRun run_square(int quads, int runs) {
    const sim::GarmentMesh base = make_square({.columns = quads, .rows = quads});
    sim::AdaptiveMesh mesh(base);
    PointerMesh<Pools> pooled(base);
    PointerMesh<NewDelete> plain(base);
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

Figure figure_of(const std::string& name, const std::string& title, const std::vector<SquareRun>& runs,
                 Samples SquareRun::*samples) {
    Figure figure;
    figure.series = {.name = name, .title = title, .columns = {"base triangles"}};
    for (const char* baseline : kBaselineNames) figure.series.columns.push_back(std::string(baseline) + ", ms");
    figure.y_label = "ms";
    figure.is_logarithmic = true;
    for (const SquareRun& run : runs) {
        std::vector<Cell> row{run.counts[0].triangles};
        for (std::size_t baseline = 0; baseline < kBaselines; ++baseline)
            row.push_back(Cell(run.total_ms(run.*samples, baseline), 4));
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

// Figure 3.9: the four ways to choose between two diagonals, as a table.

namespace {

struct TieBreaker {
    const char* name;
    DiagonalChoice choice;
};

constexpr std::array<TieBreaker, 4> kTieBreakers{{{"least work", DiagonalChoice::MinimalChange},
                                                  {"length", DiagonalChoice::Length},
                                                  {"rest length", DiagonalChoice::RestLength},
                                                  {"curvature", DiagonalChoice::Curvature}}};

std::uint64_t total(const sim::TransitionCounts& counts) {
    std::uint64_t sum = 0;
    for (const auto& row : counts.by_configuration)
        for (const std::uint64_t n : row) sum += n;
    return sum;
}

void add_row(Table& table, ThesisDropObject object, const TieBreaker& tie_breaker, const ThesisDropRun& run,
             const ThesisDropRun& uniform) {
    double triangles = 0, adaptation = 0, steps = 0;
    for (const ThesisDropFrame& frame : run.frames) {
        triangles += static_cast<double>(frame.triangles);
        adaptation += frame.adaptation;
        steps += frame.steps;
    }
    const auto n = static_cast<double>(run.frames.size());
    table.add_row({name_of(object), tie_breaker.name, Cell(triangles / n, 0), total(run.transitions),
                   Cell(adaptation / n, 4), Cell((adaptation + steps) / n, 3),
                   Cell(1e3 * mean_distance(run, uniform), 1)});
}

}  // namespace

ThesisResult measure_tie_breakers(const ThesisOptions& options) {
    Figure figure;
    figure.is_plotted = false;
    figure.series = {.name = "3.9",
                     .title = "What decides between two diagonals where either would do",
                     .note =
                         "Drops with the criteria A and B, as in table 3.14. Least work is the default; the thesis "
                         "judged the others no better. Distance: of the last drape from the uniform run's.",
                     .columns = {"object", "tie-breaker", "triangles, mean", "transitions", "adaptation, ms",
                                 "frame, ms", "distance, mm"}};
    const int runs = options.is_quick ? 1 : 3;
    for (const ThesisDropObject object : {ThesisDropObject::Cylinder, ThesisDropObject::Sphere}) {
        ThesisDropOptions drop{.object = object, .seconds = options.is_quick ? 0.3 : 3.0};
        drop.uniform_level = options.is_quick ? 1 : 3;
        const ThesisDropRun uniform = run_thesis_drop(drop);
        drop.uniform_level.reset();
        drop.criteria = {.collision = true, .curvature = true, .length = false};
        for (const TieBreaker& tie_breaker : kTieBreakers) {
            drop.diagonal = tie_breaker.choice;
            add_row(figure.series, object, tie_breaker, run_thesis_drop_repeatedly(drop, runs), uniform);
        }
    }
    ThesisResult result;
    result.figures = {figure};
    return result;
}

}  // namespace selvedge::bench
