#pragma once
// A table of figures as an experiment leaves it: printed for people as Markdown, kept for programs as JSON.
#include <concepts>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/image/image.h"
#include "sim/core/json.h"

namespace selvedge::bench {

// Text, a number or nothing at all (not measured, or not known).
class Cell {
 public:
    Cell() = default;
    Cell(std::string text) : text_(std::move(text)) {}
    Cell(const char* text) : text_(text) {}
    // Printed with so many decimals; JSON keeps all of it.
    Cell(double number, int decimals) : number_(number), decimals_(decimals) {}
    template <std::integral T>
    Cell(T count) : number_(static_cast<double>(count)) {}

    std::string to_text() const;  // "-" when there is nothing
    sim::Json to_json() const;    // a string, a number, or null when there is nothing
    bool is_number() const { return number_.has_value(); }
    bool is_empty() const { return !number_ && text_.empty(); }

 private:
    std::string text_;
    std::optional<double> number_;
    int decimals_ = 0;
};

struct Table {
    std::string name;    // for choosing it, such as "3.2"
    std::string title;   // one line
    std::string note{};  // how it was measured, in sentences; may be empty
    std::vector<std::string> columns{};
    std::vector<std::vector<Cell>> rows{};  // each as long as columns

    void add_row(std::vector<Cell> row);  // pre: as long as columns
};

// A heading, the note, and the rows under each other; columns of numbers are flush right.
std::string to_markdown(const Table& table);

// Some of its rows, evenly spread, the last among them, when there are more than `most`; the note says so.
Table thinned(const Table& table, std::size_t most);

// {"name": ..., "title": ..., "note": ..., "columns": [...], "rows": [[...], ...]}
sim::Json to_json(const Table& table);

// A series of figures as CSV, and drawn by gnuplot where that is installed.

struct Figure {
    Table series;  // columns of numbers; the first is x
    std::string y_label;
    bool is_plotted = true;       // else the series is for reading alone
    bool is_logarithmic = false;  // both axes
    std::string right_column{};   // drawn against an axis of its own, on the right; empty: none
};

// The columns' names, then a row per line; numbers with the digits that are printed, text quoted where it must be.
std::string to_csv(const Table& table);

// Draws it into a PNG file by a script that is left beside it. False when there is no gnuplot, or it would not.
bool plot(const Figure& figure, const std::filesystem::path& png);

// Pictures side by side in one.

// Row by row, so many in each, with white between. Pre: there are some, all of one size, columns >= 1.
render::Image contact_sheet(const std::vector<render::Image>& pictures, int columns);

}  // namespace selvedge::bench
