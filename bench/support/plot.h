#pragma once
// Draws series as an SVG picture: lines or bars over labelled axes with a legend. Needs no other program.
#include <string>
#include <vector>

#include "bench/support/table.h"

namespace selvedge::bench {

enum class SeriesStyle { Line, Bars };
enum class PlotAxis { Left, Right };

// y[i] over x[i]. A value that is not finite leaves a gap; on a logarithmic axis, so does one that is not positive.
struct Series {
    std::string name;  // for the legend
    std::vector<double> x{};
    std::vector<double> y{};
    SeriesStyle style = SeriesStyle::Line;
    PlotAxis axis = PlotAxis::Left;
};

// The labels name the quantity and its unit, such as "ms". Linear axes of y start at 0 unless a value is negative.
struct Plot {
    std::string title{};
    std::string x_label{};
    std::string y_label{};
    std::vector<Series> series{};
    std::string right_label{};              // of the y axis at the right, which exists if a series uses it
    std::vector<std::string> categories{};  // names of x = 0, 1 .. in place of numbers, for bars
    bool is_logarithmic = false;            // x and y; the right axis stays linear
    bool is_y_logarithmic = false;          // y only
    int width_px = 1000;
    int height_px = 600;
};

// The columns of a figure as lines over its first column. Empty cells leave gaps; columns of text are left out.
Plot plot_of(const Figure& figure);

// Round values at about `count` even steps of 1, 2 or 5 times a power of ten that lie in [low, high].
// Pre: low < high, both finite, count >= 1.
std::vector<double> tick_values(double low, double high, int count);

// A whole SVG document that also stands inside an HTML page. Text is escaped. Pre: x and y of each series have one
// size.
std::string to_svg(const Plot& plot);

}  // namespace selvedge::bench
