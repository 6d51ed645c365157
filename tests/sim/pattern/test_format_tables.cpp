// The tables of keys in patterns/FORMAT.md, compared with the descriptions of the fields: sim/pattern/pattern_fields.h
// and sim/pattern/fabric_fields.h. A line <!-- keys of Panel --> stands above the table of Panel's keys: key, value,
// default, meaning. What a value is, its range and its default follow from the field; the meaning, and the default of a
// value that is left out, are written there by hand. So are whole rows of keys that have code of their own
// (FileForm::ByHand).
//
// SELVEDGE_RENEW_GOLDENS=format build/release/test_pattern --gtest_filter='Format*'   writes what follows from fields.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "sim/core/file.h"
#include "sim/pattern/enum_names.h"
#include "sim/pattern/fabric_fields.h"
#include "sim/pattern/pattern_fields.h"
#include "tests/support/checkout.h"

namespace selvedge::sim {
namespace {

// What a value of a part is called, one and several, and the heading of its table.
struct PartWords {
    std::string one, several, heading;
};
PartWords words_of(const Thread*) {
    return {"thread", "threads", "sewing-thread"};
}
PartWords words_of(const Topstitch*) {
    return {"rows of stitches", "rows of stitches", "topstitch"};
}
PartWords words_of(const Elastic*) {
    return {"elastic", "elastics", "elastic"};
}
PartWords words_of(const InternalLine*) {
    return {"line", "lines", "internal-lines"};
}
PartWords words_of(const Notch*) {
    return {"notch", "notches", "notches"};
}

std::string link_to(const std::string& text, const std::string& heading) {
    return "[" + text + "](#" + heading + ")";
}

std::string number(double value) {
    std::ostringstream text;
    text.precision(10);
    text << value;
    return std::regex_replace(text.str(), std::regex("e-0*"), "e-");  // 1e-05
}

struct LengthUnit {
    double in_metre;
    std::string name;
};
// In which a reader knows lengths of this size.
LengthUnit unit_for(double length) {
    if (length >= 10) return {1, " m"};
    return length >= 0.05 ? LengthUnit{100, " cm"} : LengthUnit{1000, " mm"};
}

bool has_lengths(Measure measure) {
    return is_length(measure) || measure == Measure::Point || measure == Measure::ClothShift;
}

// ", 0 to 50 cm"; empty if any number will do.
std::string range_text(const auto& field) {
    const Range& range = field.range;
    if (!std::isfinite(range.least) || !std::isfinite(range.most)) return "";
    const LengthUnit unit = has_lengths(field.measure) ? unit_for(range.most) : LengthUnit{1, ""};
    return ", " + number(range.least * unit.in_metre) + " to " + number(range.most * unit.in_metre) + unit.name;
}

// What a value of this type is: one, or several in a list.
struct ValueWords {
    std::string one, several;
};
ValueWords value_words(const auto&, bool) {
    return {"`true` or `false`", ""};
}
ValueWords value_words(const auto& field, double) {
    if (is_length(field.measure)) return {"length", "lengths"};
    return is_angle(field.measure) ? ValueWords{"degrees", "degrees"} : ValueWords{"number", "numbers"};
}
ValueWords value_words(const auto& field, int) {
    if (field.measure == Measure::EdgeIndex) return {"index of an edge", "indices of edges"};
    if (field.measure == Measure::VertexIndex) return {"index of a vertex", "indices of vertices"};
    return {"whole number", "whole numbers"};
}
ValueWords value_words(const auto& field, const std::string&) {
    if (field.measure == Measure::Colour) return {"colour, `#RRGGBB`", "colours"};
    return field.measure == Measure::Fabric ? ValueWords{"fabric", "fabrics"} : ValueWords{"text", "texts"};
}
ValueWords value_words(const auto& field, const Vec2d&) {
    if (field.measure == Measure::Point) return {"point, `[x, y]`", "points, `[x, y]`"};
    return has_lengths(field.measure) ? ValueWords{"two lengths, `[a, b]`", "pairs of lengths"}
                                      : ValueWords{"two numbers, `[a, b]`", "pairs of numbers"};
}
template <class T>
requires std::is_enum_v<T> ValueWords value_words(const auto&, T) {
    std::string text;
    const auto names = names_of(T{}).texts;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 < names.size() ? ", " : " or ";
        text += "`" + std::string(names[i]) + "`";
    }
    return {text, text};
}
template <Described T>
ValueWords value_words(const auto&, const T&) {
    const PartWords words = words_of(static_cast<const T*>(nullptr));
    return {link_to(words.one, words.heading), link_to(words.several, words.heading)};
}
template <class T>
ValueWords value_words(const auto& field, const std::optional<T>&) {
    return value_words(field, T{});
}
template <class T>
ValueWords value_words(const auto& field, const std::vector<T>&) {
    return {"list of " + value_words(field, T{}).several, ""};
}

// The default, as text. Empty: none, so that the page says by hand what holds then.
std::string default_text(const auto&, bool value) {
    return value ? "`true`" : "`false`";
}
std::string default_text(const auto& field, double value) {
    if (!has_lengths(field.measure) || value == 0) return number(is_angle(field.measure) ? value / kDegree : value);
    const LengthUnit unit = unit_for(value);
    return number(value * unit.in_metre) + unit.name;
}
std::string default_text(const auto&, int value) {
    return std::to_string(value);
}
std::string default_text(const auto&, const std::string& value) {
    return value.empty() ? "" : "`" + value + "`";
}
std::string default_text(const auto& field, const Vec2d& value) {
    if (!has_lengths(field.measure) || value.isZero())
        return "`[" + number(value.x()) + ", " + number(value.y()) + "]`";
    return default_text(field, value.x()) +
           (value.x() == value.y() ? " each" : " and " + default_text(field, value.y()));
}
template <class T>
requires std::is_enum_v<T> std::string default_text(const auto&, T value) {
    return "`" + std::string(name_of_value(value)) + "`";
}
template <Described T>
std::string default_text(const auto&, const T&) {
    return "its defaults";
}
template <class T>
std::string default_text(const auto&, const std::optional<T>&) {
    return "";
}
template <class T>
std::string default_text(const auto&, const std::vector<T>&) {
    return "";
}

struct Row {
    std::string key;  // with its backquotes
    std::string value = {}, usual = {}, meaning = {};

    std::string line() const { return "| " + key + " | " + value + " | " + usual + " | " + meaning + " |"; }
};
const std::vector<std::string> kHead{"| key | value | default | meaning |", "|---|---|---|---|"};

Row parse_row(const std::string& line) {
    std::vector<std::string> cells;
    std::size_t from = 2;
    for (std::size_t end = 0; (end = line.find(" |", from)) != std::string::npos; from = std::min(end + 3, line.size()))
        cells.push_back(line.substr(from, end - from));
    cells.resize(4);
    return {.key = cells[0], .value = cells[1], .usual = cells[2], .meaning = cells[3]};
}

// What the description of a part says of its table.
struct Table {
    std::string part;
    std::vector<Row> rows = {};          // of fields that are keys; without meaning
    std::set<std::string> by_hand = {};  // keys of other fields, which the page may describe too
};

template <class Part>
void add_fields(Table& table) {
    const Part usual{};
    visit_fields(usual, [&]<class SomeField>(const SomeField& field, const auto& value) {
        const std::string key = "`" + std::string(field.key) + "`";
        if constexpr (SomeField::is_key) {
            table.rows.push_back(
                {.key = key,
                 .value = value_words(field, value).one + range_text(field),
                 .usual = SomeField::form == FileForm::Required ? "required" : default_text(field, value)});
        } else if constexpr (SomeField::form == FileForm::ByHand) {
            table.by_hand.insert(key);
        }
    });
}

template <class Part>
Table table_of(const std::string& part) {
    Table table{.part = part};
    add_fields<Part>(table);
    return table;
}

// Of each part that has keys of its own. What all seams of a garment are called is among the garment's keys.
std::vector<Table> all_tables() {
    std::vector<Table> tables{
        table_of<Pattern>("Pattern"),           table_of<Panel>("Panel"),         table_of<OutlineEdge>("OutlineEdge"),
        table_of<InternalLine>("InternalLine"), table_of<Notch>("Notch"),         table_of<Seam>("Seam"),
        table_of<WrapCone>("WrapCone"),         table_of<Topstitch>("Topstitch"), table_of<Thread>("Thread"),
        table_of<Elastic>("Elastic"),           table_of<Fabric>("Fabric")};
    tables.front().by_hand.insert("`format`");  // of the file
    tables.front().by_hand.merge(std::set<std::string>(tables[5].by_hand));
    return tables;
}

using Lines = std::vector<std::string>;

// The rows of the page, in its order, with what follows from the fields; then rows of fields that it lacks.
std::vector<Row> renewed_rows(std::vector<Row> rows, const Table& table) {
    std::erase_if(rows, [&](const Row& row) {
        return !table.by_hand.contains(row.key) &&
               std::ranges::find(table.rows, row.key, &Row::key) == table.rows.end();
    });
    for (const Row& described : table.rows) {
        auto row = std::ranges::find(rows, described.key, &Row::key);
        if (row == rows.end()) row = rows.insert(rows.end(), {.key = described.key});
        row->value = described.value;
        if (!described.usual.empty()) row->usual = described.usual;
    }
    return rows;
}

// Renews the table of the page. Adds what is wrong and cannot be made from fields to `problems`.
void renew_table(Lines& page, const Table& table, Lines& problems) {
    const auto marker = std::ranges::find(page, "<!-- keys of " + table.part + " -->");
    if (marker == page.end()) return problems.push_back("no table of the keys of " + table.part);
    const auto first = marker + 1;
    const auto end = std::find_if(first, page.end(), [](const std::string& line) { return !line.starts_with('|'); });
    std::vector<Row> rows;
    for (auto line = first + std::min<std::ptrdiff_t>(end - first, 2); line != end; ++line)
        rows.push_back(parse_row(*line));
    rows = renewed_rows(std::move(rows), table);
    Lines lines = kHead;
    for (const Row& row : rows) {
        lines.push_back(row.line());
        if (row.usual.empty()) problems.push_back(table.part + ": no default of " + row.key);
        if (row.meaning.empty()) problems.push_back(table.part + ": no meaning of " + row.key);
    }
    page.insert(page.erase(first, end), lines.begin(), lines.end());
}

Lines renew(Lines& page, const std::vector<Table>& tables) {
    Lines problems;
    for (const Table& table : tables) renew_table(page, table, problems);
    return problems;
}

std::filesystem::path format_page() {
    return std::filesystem::path(source_folder()) / "patterns" / "FORMAT.md";
}

Lines lines_of(const std::string& text) {
    Lines lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

TEST(FormatTables, match_the_fields) {
    const Lines page = lines_of(read_file(format_page(), std::size_t{1} << 20));
    Lines renewed = page;
    for (const std::string& problem : renew(renewed, all_tables())) ADD_FAILURE() << problem;
    const char* names = std::getenv("SELVEDGE_RENEW_GOLDENS");
    if (names && std::string(names) == "format") {
        std::ofstream file(format_page(), std::ios::binary);
        for (const std::string& line : renewed) file << line << "\n";
        return;
    }
    for (std::size_t i = 0; i < std::min(page.size(), renewed.size()); ++i)
        ASSERT_EQ(page[i], renewed[i]) << "patterns/FORMAT.md:" << i + 1;
    EXPECT_EQ(page.size(), renewed.size());
}

const Lines kNotchPage{"# Notches",
                       "<!-- keys of Notch -->",
                       kHead[0],
                       kHead[1],
                       "| `edge` | index of an edge | required | where it lies |",
                       "| `at` | number, 0 to 1 | required | how far along |",
                       "| `kind` | `slit`, `v`, `t`, `castle` or `u` | `slit` | its form |",
                       "| `count` | whole number, 1 to 9 | 1 | of how many it is made |",
                       "text"};

TEST(FormatTables, leave_a_correct_page_unchanged) {
    Lines page = kNotchPage;
    EXPECT_EQ(renew(page, {table_of<Notch>("Notch")}), Lines());
    EXPECT_EQ(page, kNotchPage);
}

TEST(FormatTables, correct_ranges_and_defaults_and_keep_meanings) {
    Lines page = kNotchPage;
    page[6] = "| `kind` | `slit` or `v` | `v` | its form |";
    page[7] = "| `count` | whole number, 1 to 7 | 2 | of how many it is made |";
    EXPECT_EQ(renew(page, {table_of<Notch>("Notch")}), Lines());
    EXPECT_EQ(page, kNotchPage);
}

TEST(FormatTables, report_a_missing_key_and_a_missing_table) {
    Lines page = kNotchPage;
    page[7] = "| `counts` | whole number, 1 to 9 | 1 | is no key any more |";
    EXPECT_EQ(renew(page, {table_of<Notch>("Notch")}), Lines{"Notch: no meaning of `count`"});
    EXPECT_EQ(page[7], "| `count` | whole number, 1 to 9 | 1 |  |");
    EXPECT_EQ(page.size(), kNotchPage.size());
    EXPECT_EQ(renew(page, {table_of<Thread>("Thread")}), Lines{"no table of the keys of Thread"});
}

TEST(FormatTables, report_a_missing_default) {
    Lines page{"<!-- keys of Seam -->", kHead[0], kHead[1], "| `topstitch` |  |  | rows beside the seam |"};
    EXPECT_EQ(renew(page, {table_of<Seam>("Seam")}), Lines{"Seam: no default of `topstitch`"});
    EXPECT_EQ(page[3], "| `topstitch` | [rows of stitches](#topstitch) |  | rows beside the seam |");
}

}  // namespace
}  // namespace selvedge::sim
