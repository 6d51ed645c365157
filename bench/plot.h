#pragma once
// A series of figures as CSV, and drawn by gnuplot where that is installed.
#include <filesystem>
#include <string>
#include <vector>

#include "bench/table.h"

namespace selvedge {

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

}  // namespace selvedge
