#include "bench/support/table.h"

#include <algorithm>
#include <cstdio>

#include "sim/core/assert.h"

namespace selvedge::bench {
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

sim::Json Cell::to_json() const {
    if (number_) return decimals_ == 0 ? sim::Json(static_cast<long long>(*number_)) : sim::Json(*number_);
    return text_.empty() ? sim::Json() : sim::Json(text_);
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

sim::Json to_json(const Table& table) {
    sim::Json json = sim::Json::object();
    json["name"] = table.name;
    json["title"] = table.title;
    json["note"] = table.note;
    json["columns"] = sim::Json::array({table.columns.begin(), table.columns.end()});
    sim::Json rows = sim::Json::array();
    for (const std::vector<Cell>& row : table.rows) {
        sim::Json cells = sim::Json::array();
        for (const Cell& cell : row) cells.push_back(cell.to_json());
        rows.push_back(std::move(cells));
    }
    json["rows"] = std::move(rows);
    return json;
}

namespace {

std::string csv_word(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

std::string csv_cell(const Cell& cell) {
    return cell.is_empty() ? "" : csv_word(cell.to_text());
}

}  // namespace

std::string to_csv(const Table& table) {
    std::string text;
    for (std::size_t i = 0; i < table.columns.size(); ++i) text += (i > 0 ? "," : "") + csv_word(table.columns[i]);
    text += "\n";
    for (const std::vector<Cell>& row : table.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) text += (i > 0 ? "," : "") + csv_cell(row[i]);
        text += "\n";
    }
    return text;
}

render::Image contact_sheet(const std::vector<render::Image>& pictures, int columns) {
    constexpr int kGap = 4;  // px
    SELVEDGE_ASSERT(!pictures.empty() && columns >= 1);
    const int width = pictures.front().width_px, height = pictures.front().height_px;
    const int count = static_cast<int>(pictures.size()), rows = (count + columns - 1) / columns;
    render::Image sheet(columns * (width + kGap) - kGap, rows * (height + kGap) - kGap, {255, 255, 255, 255});
    for (int i = 0; i < count; ++i) {
        const render::Image& picture = pictures[static_cast<std::size_t>(i)];
        SELVEDGE_ASSERT(picture.width_px == width && picture.height_px == height);
        const int left = i % columns * (width + kGap), top = i / columns * (height + kGap);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) sheet.at(left + x, top + y) = picture.at(x, y);
        }
    }
    return sheet;
}

}  // namespace selvedge::bench
