#pragma once
// The results of an experiment: a table, written as Markdown, JSON or CSV; a figure (a table that plot_of() draws);
// and a contact sheet that combines several images.
#include <concepts>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/image/image.h"
#include "sim/core/json.h"

namespace selvedge::bench {

// Text, a number, or empty (not measured or not known).
class Cell {
 public:
    Cell() = default;
    Cell(std::string text) : text_(std::move(text)) {}
    Cell(const char* text) : text_(text) {}
    // Markdown and CSV print this many decimals. JSON keeps full precision, but 0 decimals truncates to an integer.
    Cell(double number, int decimals) : number_(number), decimals_(decimals) {}
    template <std::integral T>
    Cell(T count) : number_(static_cast<double>(count)) {}

    std::string to_text() const;  // "-" if empty
    sim::Json to_json() const;    // a string, a number, or null if empty
    bool is_number() const { return number_.has_value(); }
    bool is_empty() const { return !number_ && text_.empty(); }

 private:
    std::string text_;
    std::optional<double> number_;
    int decimals_ = 0;
};

struct Table {
    std::string name;    // selects the table on the command line, such as "3.2"
    std::string title;   // one line
    std::string note{};  // how it was measured, in full sentences; may be empty
    std::vector<std::string> columns{};
    std::vector<std::vector<Cell>> rows{};  // each has as many cells as columns

    void add_row(std::vector<Cell> row);  // pre: row has as many cells as columns
};

// A heading, the note and the rows. Columns of numbers are right-aligned.
std::string to_markdown(const Table& table);

// If the table has more than `most` rows: keeps evenly spaced rows, including the last one, and says so in the note.
Table thinned(const Table& table, std::size_t most);

// {"name": ..., "title": ..., "note": ..., "columns": [...], "rows": [[...], ...]}
sim::Json to_json(const Table& table);

// Figures: a series of values, written as CSV and drawn (bench/support/plot.h).

struct Figure {
    Table series;  // columns of numbers; the first column is x
    std::string y_label;
    bool is_logarithmic = false;    // both axes
    bool is_y_logarithmic = false;  // the left y axis only
    std::string right_column{};     // the column that uses the right-hand y axis; empty: none
};

// The column names, then one line per row. Numbers have the decimals of to_text(); text is quoted if necessary.
std::string to_csv(const Table& table);

// Combines images into one, row by row with `columns` images per row and white gaps between them.
// Pre: at least one image, all of one size, columns >= 1.
render::Image contact_sheet(const std::vector<render::Image>& pictures, int columns);

}  // namespace selvedge::bench
