#include "bench/thesis/drop_trends.h"

#include <algorithm>
#include <optional>

namespace selvedge::bench {
namespace {

const Table* find_table(const ThesisResult& result, const std::string& name) {
    const auto found = std::ranges::find(result.tables, name, &Table::name);
    return found == result.tables.end() ? nullptr : &*found;
}

// The number in that column of the first row whose cells have these texts. Columns are given by name.
using Conditions = std::vector<std::pair<std::string, std::string>>;

std::optional<std::size_t> column_of(const Table& table, const std::string& name) {
    const auto found = std::ranges::find(table.columns, name);
    if (found == table.columns.end()) return std::nullopt;
    return static_cast<std::size_t>(found - table.columns.begin());
}

std::optional<double> value_at(const Table& table, const Conditions& where, const std::string& column) {
    const auto wanted = column_of(table, column);
    if (!wanted) return std::nullopt;
    for (const std::vector<Cell>& row : table.rows) {
        const bool is_it = std::ranges::all_of(where, [&](const auto& condition) {
            const auto at = column_of(table, condition.first);
            return at && row[*at].to_text() == condition.second;
        });
        if (is_it && row[*wanted].is_number()) return row[*wanted].to_json().number();
    }
    return std::nullopt;
}

std::string text(double value, int decimals) {
    return Cell(value, decimals).to_text();
}

void judge_frequencies(const Table& table, std::vector<Trend>& trends) {
    const auto splits = value_at(table, {{"from", "S0"}}, "S7"), rejoins = value_at(table, {{"from", "S7"}}, "S0");
    if (!splits || !rejoins) return;
    trends.push_back({.item = "T3.1",
                      .reported = "S0 to S7 in 9.1 % and S7 to S0 in 2.7 % of the transitions: more refinement than "
                                  "coarsening at once.",
                      .measured = text(*splits, 1) + " % and " + text(*rejoins, 1) + " %.",
                      .agrees = *splits > *rejoins});
}

// A column at levels 0 to 3 of a cloth, as a list; and whether it rises.
struct LevelValues {
    std::string list;
    bool rises = true;
};

template <class Value>  // Value(level) is a number, or nullopt where the table has no such level
std::optional<LevelValues> level_values(const Value& value_of, int decimals) {
    LevelValues values;
    double before = 0;
    for (const char* level : {"0", "1", "2", "3"}) {
        const std::optional<double> value = value_of(level);
        if (!value) return std::nullopt;
        values.list += (values.list.empty() ? "" : ", ") + text(*value, decimals);
        values.rises = values.rises && *value > before;
        before = *value;
    }
    return values;
}

void judge_uniform(const Table& table, std::vector<Trend>& trends) {
    const auto times = [&](const char* cloth) {
        return level_values(
            [&](const char* level) {
                return value_at(table, {{"cloth", cloth}, {"level", level}}, "total update CPU, ms");
            },
            2);
    };
    const auto shares = level_values(
        [&](const char* level) -> std::optional<double> {
            const Conditions row{{"cloth", "selvedge"}, {"level", level}};
            const auto collision = value_at(table, row, "collision, ms"),
                       total = value_at(table, row, "total update, ms");
            if (!collision || !total) return std::nullopt;
            return 100 * *collision / *total;
        },
        0);
    const auto ours = times("selvedge"), at_vertices = times("vertices only"), mass_spring = times("mass-spring");
    if (!shares || !ours || !at_vertices || !mass_spring) return;
    std::string why;
    if (!ours->rises) {
        why =
            ", of it " + shares->list +
            " % collision: coarse triangles that may not be split have contact points between their vertices, at most "
            "2.5 cm apart, of which few can be solved at once, because they share their vertices";
    }
    trends.push_back({.item = "T" + table.name,
                      .reported = "each uniform level costs more than the one above it.",
                      .measured = "an update takes " + ours->list + " ms of CPU time at levels 0 to 3" + why +
                                  ". With contact at vertices alone, as in the thesis, " + at_vertices->list +
                                  " ms; the mass-spring cloth " + mass_spring->list + " ms.",
                      .agrees = ours->rises && at_vertices->rises && mass_spring->rises});
}

struct Criteria {
    const Table& table;
    const char* object;

    double of(const char* criteria, const char* column) const {
        return value_at(table, {{"object", object}, {"cloth", "selvedge"}, {"criteria", criteria}}, column).value_or(0);
    }
};

void judge_savings(const Table& table, std::vector<Trend>& trends) {
    Trend saves{.item = "T3.14",
                .reported = "the adaptive cloth has fewer triangles than the uniform one and costs less.",
                .measured = {},
                .agrees = true};
    for (const char* object : {"sphere", "cylinder"}) {
        const Criteria row{table, object};
        const double uniform = row.of("uniform", "triangles, mean"), all = row.of("A+B+C", "triangles, mean");
        const double share = row.of("A+B+C", "share of uniform");
        saves.agrees = saves.agrees && all < uniform && share < 1;
        saves.measured += "On the " + std::string(object) + " A+B+C has " + text(all, 0) + " of " + text(uniform, 0) +
                          " triangles and takes " + text(share, 2) + " of the time; B alone takes " +
                          text(row.of("B", "share of uniform"), 2) + " and C alone " +
                          text(row.of("C", "share of uniform"), 2) + ". ";
    }
    saves.measured +=
        "Without A nothing is split where cloth touches, and contact points between the vertices of coarse "
        "triangles cost more than the triangles saved.";
    trends.push_back(std::move(saves));
}

// C by itself and beside other criteria. A difference of the bend of 2 % is chance: two uniform runs that start 1 mm
// apart differ by 1 %.
void judge_wrinkles(const Table& table, std::vector<Trend>& trends) {
    constexpr double kMore = 1.02;
    Trend wrinkles{.item = "F3.24",
                   .reported = "C by itself is ineffective; combined with other criteria it makes more wrinkles.",
                   .measured = {},
                   .agrees = true};
    struct Pair {
        const char *without, *with;
    };
    for (const char* object : {"sphere", "cylinder"}) {
        const Criteria row{table, object};
        const double alone = row.of("C", "triangles, mean"), others = row.of("A", "triangles, mean");
        wrinkles.agrees = wrinkles.agrees && alone < others;
        wrinkles.measured += "On the " + std::string(object) + " C alone has " + text(alone, 0) + " triangles (A " +
                             text(others, 0) + "), and the cloth bends by";
        for (const Pair& pair : {Pair{"A", "A+C"}, Pair{"B", "B+C"}, Pair{"A+B", "A+B+C"}}) {
            const double before = row.of(pair.without, "bend, 1/m"), after = row.of(pair.with, "bend, 1/m");
            wrinkles.agrees = wrinkles.agrees && after > kMore * before;
            wrinkles.measured += std::string(pair.without[1] == '\0' && pair.without[0] == 'A' ? " " : ", ") +
                                 text(after, 2) + " per m with " + pair.with + " (" + pair.without + " " +
                                 text(before, 2) + ")";
        }
        wrinkles.measured += ". ";
    }
    if (!wrinkles.agrees)
        wrinkles.measured +=
            "Beside A alone C adds folds on the sphere. B has split them already; and on the cylinder, "
            "which the cloth wraps without folds, nothing is compressed.";
    trends.push_back(std::move(wrinkles));
}

// Whether the cloth refines on the object; and by collision alone, whether it is coarse again once it has fallen off.
// Other criteria keep the folds of a cloth that falls on.
void judge_timings(const Table& series, std::vector<Trend>& trends) {
    const auto column = column_of(series, "triangles");
    if (!column || series.rows.empty()) return;
    double most = 0;
    for (const std::vector<Cell>& row : series.rows) most = std::max(most, row[*column].to_json().number());
    const double last = series.rows.back()[*column].to_json().number();
    const double first = series.rows.front()[*column].to_json().number();
    const bool is_by_collision = series.title.find("[A]") != std::string::npos;
    trends.push_back({.item = "F" + series.name,
                      .reported = is_by_collision
                                      ? "the triangle count rises on the object and falls when the cloth leaves it."
                                      : "the triangle count rises on the object.",
                      .measured = text(first, 0) + " triangles at first, " + text(most, 0) + " at most, " +
                                  text(last, 0) + " at the end" +
                                  (is_by_collision ? "." : ", when the cloth falls freely, in the folds that it has."),
                      .agrees = most > first && (!is_by_collision || last == first)});
}

}  // namespace

std::vector<Trend> drop_trends(const ThesisResult& result) {
    std::vector<Trend> trends;
    if (const Table* table = find_table(result, "3.1")) judge_frequencies(*table, trends);
    for (const char* name : {"3.12", "3.13"}) {
        if (const Table* table = find_table(result, name)) judge_uniform(*table, trends);
    }
    if (const Table* table = find_table(result, "3.14")) {
        judge_savings(*table, trends);
        judge_wrinkles(*table, trends);
    }
    for (const Figure& figure : result.figures) judge_timings(figure.series, trends);
    return trends;
}

}  // namespace selvedge::bench
