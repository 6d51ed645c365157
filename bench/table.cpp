#include "bench/table.h"

#include <algorithm>
#include <cstdio>

#include "sim/core/assert.h"

namespace selvedge {
namespace {

using TextRow = std::vector<std::string>;

bool is_number_column(const Table& table, std::size_t column) {
    const auto is_number_or_empty = [&](const std::vector<Cell>& row) {
        return row[column].is_number() || row[column].is_empty();
    };
    return !table.rows.empty() && std::all_of(table.rows.begin(), table.rows.end(), is_number_or_empty);
}

std::string padded_to(const std::string& text, std::size_t width, bool flush_right) {
    const std::string gap(width - std::min(width, text.size()), ' ');
    return flush_right ? gap + text : text + gap;
}

std::string line_of(const TextRow& row, const std::vector<std::size_t>& widths, const std::vector<bool>& flush_right) {
    std::string line = "|";
    for (std::size_t i = 0; i < row.size(); ++i) line += " " + padded_to(row[i], widths[i], flush_right[i]) + " |";
    return line + "\n";
}

std::string rule_of(const std::vector<std::size_t>& widths, const std::vector<bool>& flush_right) {
    std::string line = "|";
    for (std::size_t i = 0; i < widths.size(); ++i)
        line += std::string(widths[i] + 1, '-') + (flush_right[i] ? ":" : "-") + "|";
    return line + "\n";
}

}  // namespace

std::string Cell::to_text() const {
    if (!number_) return text_.empty() ? "-" : text_;
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals_, *number_);
    return text;
}

Json Cell::to_json() const {
    if (number_) return decimals_ == 0 ? Json(static_cast<long long>(*number_)) : Json(*number_);
    return text_.empty() ? Json() : Json(text_);
}

void Table::add_row(std::vector<Cell> row) {
    SELVEDGE_ASSERT(row.size() == columns.size());
    rows.push_back(std::move(row));
}

std::string to_markdown(const Table& table) {
    std::vector<TextRow> lines{table.columns};
    for (const std::vector<Cell>& row : table.rows) {
        TextRow& line = lines.emplace_back();
        for (const Cell& cell : row) line.push_back(cell.to_text());
    }
    std::vector<std::size_t> widths(table.columns.size(), 1);
    std::vector<bool> flush_right(table.columns.size());
    for (std::size_t i = 0; i < widths.size(); ++i) {
        for (const TextRow& line : lines) widths[i] = std::max(widths[i], line[i].size());
        flush_right[i] = is_number_column(table, i);
    }
    std::string text = "## " + table.name + ": " + table.title + "\n\n";
    if (!table.note.empty()) text += table.note + "\n\n";
    text += line_of(lines[0], widths, flush_right) + rule_of(widths, flush_right);
    for (std::size_t i = 1; i < lines.size(); ++i) text += line_of(lines[i], widths, flush_right);
    return text;
}

Table thinned(const Table& table, std::size_t most) {
    if (table.rows.size() <= most) return table;
    const std::size_t stride = (table.rows.size() + most - 1) / most;
    Table part = table;
    part.rows.clear();
    for (std::size_t i = (table.rows.size() - 1) % stride; i < table.rows.size(); i += stride)
        part.rows.push_back(table.rows[i]);
    part.note += (part.note.empty() ? "" : " ") + std::string("One row in ") + std::to_string(stride) + " is printed.";
    return part;
}

Json to_json(const Table& table) {
    Json json = Json::object();
    json["name"] = table.name;
    json["title"] = table.title;
    json["note"] = table.note;
    json["columns"] = Json::array({table.columns.begin(), table.columns.end()});
    Json rows = Json::array();
    for (const std::vector<Cell>& row : table.rows) {
        Json cells = Json::array();
        for (const Cell& cell : row) cells.push_back(cell.to_json());
        rows.push_back(std::move(cells));
    }
    json["rows"] = std::move(rows);
    return json;
}

}  // namespace selvedge
