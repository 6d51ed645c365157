// Tables 3.2-3.5: what one transition of one triangle costs, direct and by way of C0.
#include <array>

#include "bench/thesis/drop.h"
#include "bench/thesis/thesis.h"
#include "bench/timing.h"
#include "sim/adaptive/square.h"

namespace selvedge {
namespace {

using Matrix = std::array<std::array<double, kConfigurations>, kConfigurations>;  // us, by (from, to)

// Base triangles whose edges are all split, so that each may take any configuration.
class TestBed {
 public:
    explicit TestBed(int quads) : mesh_(make_square({.columns = quads, .rows = quads}), {.max_level = 1}) {
        const std::vector<EdgeId> edges(mesh_.unsplit_edges(0).begin(), mesh_.unsplit_edges(0).end());
        for (const EdgeId e : edges) mesh_.split(e);
    }

    std::size_t size() const { return mesh_.base_triangle_count(); }

    void change_all(Configuration to) {
        for (std::uint32_t t = 0; t < size(); ++t) mesh_.change_configuration(TriangleId(t), to);
    }
    void change_all_by_c0(Configuration to) {
        for (std::uint32_t t = 0; t < size(); ++t) {
            mesh_.change_configuration(TriangleId(t), Configuration::C0);
            mesh_.change_configuration(TriangleId(t), to);
        }
    }

 private:
    AdaptiveMesh mesh_;
};

struct Costs {
    Matrix direct{};
    Matrix indirect{};
};

template <class F>
void for_each_pair(F&& f) {
    for (std::size_t from = 0; from < kConfigurations; ++from) {
        for (std::size_t to = 0; to < kConfigurations; ++to) {
            if (from != to) f(from, to);
        }
    }
}

// Direct and indirect in turns.
Costs measure(const ThesisOptions& options) {
    TestBed bed(options.is_quick ? 2 : 16);
    Costs costs;
    const int runs = options.is_quick ? 1 : 21;
    for_each_pair([&](std::size_t from, std::size_t to) {
        const auto start = static_cast<Configuration>(from), end = static_cast<Configuration>(to);
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

Table ends_table(const Costs& costs) {
    Table table{.name = "3.2",
                .title = "Clearing a configuration and configuring from C0",
                .note = "us of one transition of one triangle: median of runs over 512 triangles that are all changed.",
                .columns = {"configuration", "clearing to C0, us", "configuring from C0, us"}};
    for (std::size_t c = 1; c < kConfigurations; ++c)
        table.add_row({name_of(c), Cell(costs.direct[c][0], 3), Cell(costs.direct[0][c], 3)});
    return table;
}

Table matrix_table(const Matrix& values, const std::string& name, const std::string& title, int decimals) {
    Table table{.name = name, .title = title, .note = "Rows: from. Columns: to.", .columns = {"from"}};
    for (std::size_t to = 0; to < kConfigurations; ++to) table.columns.push_back(name_of(to));
    for (std::size_t from = 0; from < kConfigurations; ++from) {
        std::vector<Cell> row{name_of(from)};
        for (std::size_t to = 0; to < kConfigurations; ++to)
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

// Sums over all pairs, each by its weight.
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

Table means_table(const Costs& costs, const TransitionCounts& recorded) {
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
    const DropRun drop = run_drop({.object = DropObject::Sphere,
                                   .criteria = {.collision = true, .curvature = true, .length = false},
                                   .seconds = options.is_quick ? 0.4 : 2.0});
    ThesisResult result;
    result.tables = {ends_table(costs),
                     matrix_table(costs.indirect, "3.3", "Indirect transitions, by way of C0, us", 3),
                     matrix_table(costs.direct, "3.4", "Direct transitions, us", 3),
                     matrix_table(ratio(costs), "3.5", "Direct transitions as a share of indirect ones, %", 1),
                     means_table(costs, drop.transitions)};
    return result;
}

}  // namespace selvedge
