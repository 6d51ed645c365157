#include "bench/support/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "sim/core/assert.h"

namespace selvedge::bench {
namespace {

constexpr int kLeft = 80, kTop = 44, kBottom = 96, kNarrow = 24, kRight = 80;  // px, margins round the axes
constexpr int kLegendColumns = 4;
constexpr int kLegendRow = 18;  // px
constexpr std::array kColours{"#1b6ca8", "#c8502a", "#3a8c4e", "#8a4fa3", "#b8860b", "#5a6570", "#c2417c", "#1f9e9e"};

std::string text_of(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", number);
    return text;
}

std::string px(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", number);
    return text;
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '&') {
            out += "&amp;";
        } else if (c == '<') {
            out += "&lt;";
        } else if (c == '>') {
            out += "&gt;";
        } else if (c == '"') {
            out += "&quot;";
        } else {
            out += c;
        }
    }
    return out;
}

// One axis: values low .. high lie at from .. to px, by their logarithms if is_logarithmic.
struct Scale {
    double low = 0, high = 1;
    double from = 0, to = 1;
    bool is_logarithmic = false;

    bool holds(double value) const { return std::isfinite(value) && (!is_logarithmic || value > 0); }
    double at(double value) const {
        const double t = is_logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
        return from + t * (to - from);
    }
    std::vector<double> ticks(int count) const {
        if (!is_logarithmic) return tick_values(low, high, count);
        std::vector<double> values;
        for (double v = low; v <= high * 1.0001; v *= 10) values.push_back(v);
        return values;
    }
};

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double value, bool is_logarithmic) {
        if (!std::isfinite(value) || (is_logarithmic && value <= 0)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    bool is_empty() const { return low > high; }
};

// The scale's ends: powers of ten if logarithmic, else the range itself, widened where it has no length.
Scale scale_of(Range range, bool is_logarithmic) {
    if (range.is_empty()) range = {is_logarithmic ? 1.0 : 0.0, is_logarithmic ? 10.0 : 1.0};
    Scale scale{.low = range.low, .high = range.high, .is_logarithmic = is_logarithmic};
    if (is_logarithmic) {
        scale.low = std::pow(10, std::floor(std::log10(range.low)));
        scale.high = std::max(std::pow(10, std::ceil(std::log10(range.high))), 10 * scale.low);
    } else if (range.low == range.high) {
        scale.high = range.low + std::max(1.0, std::abs(range.low));
    }
    return scale;
}

// The axis of y from 0 to just above the greatest value, or from the least value if one is negative.
Scale y_scale(const Plot& plot, PlotAxis axis, bool is_logarithmic) {
    Range range;
    for (const Series& series : plot.series) {
        if (series.axis != axis) continue;
        for (const double y : series.y) range.add(y, is_logarithmic);
    }
    if (!is_logarithmic && !range.is_empty()) {
        range.low = std::min(range.low, 0.0);
        range.high = std::max(range.high, 0.0) + 0.05 * (std::max(range.high, 0.0) - range.low);
    }
    return scale_of(range, is_logarithmic);
}

bool has_bars(const Plot& plot) {
    return std::ranges::any_of(plot.series, [](const Series& s) { return s.style == SeriesStyle::Bars; });
}

Scale x_scale(const Plot& plot) {
    const bool is_logarithmic = plot.is_logarithmic && !has_bars(plot);
    Range range;
    for (const Series& series : plot.series) {
        for (const double x : series.x) range.add(x, is_logarithmic);
    }
    if (!plot.categories.empty()) range = {0, static_cast<double>(plot.categories.size() - 1)};
    if (has_bars(plot) && !range.is_empty()) range = {range.low - 0.5, range.high + 0.5};
    return scale_of(range, is_logarithmic);
}

struct Axes {
    Scale x, left, right;
    bool has_right = false;

    const Scale& y(const Series& series) const { return series.axis == PlotAxis::Right ? right : left; }
};

Axes axes_of(const Plot& plot) {
    const auto is_right = [](const Series& s) { return s.axis == PlotAxis::Right; };
    Axes axes{.x = x_scale(plot),
              .left = y_scale(plot, PlotAxis::Left, plot.is_logarithmic || plot.is_y_logarithmic),
              .right = y_scale(plot, PlotAxis::Right, false),
              .has_right = std::ranges::any_of(plot.series, is_right)};
    axes.x.from = kLeft;
    axes.x.to = plot.width_px - (axes.has_right ? kRight : kNarrow);
    const int rows = static_cast<int>(plot.series.size() + kLegendColumns - 1) / kLegendColumns;
    axes.left.from = axes.right.from = plot.height_px - kBottom - (std::max(1, rows) - 1) * kLegendRow;
    axes.left.to = axes.right.to = kTop;
    return axes;
}

std::string line(double x0, double y0, double x1, double y1, const char* colour) {
    return "<line x1=\"" + px(x0) + "\" y1=\"" + px(y0) + "\" x2=\"" + px(x1) + "\" y2=\"" + px(y1) + "\" stroke=\"" +
           colour + "\"/>\n";
}

std::string label(double x, double y, const char* anchor, const std::string& text, const std::string& more = "") {
    return "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\" text-anchor=\"" + anchor + "\"" + more + ">" + escaped(text) +
           "</text>\n";
}

std::string upright(double x, double y) {
    return " transform=\"rotate(-90 " + px(x) + " " + px(y) + ")\"";
}

std::string draw_x_axis(const Plot& plot, const Axes& axes) {
    const double bottom = axes.left.from;
    std::string svg = line(axes.x.from, bottom, axes.x.to, bottom, "#444");
    const auto tick = [&](double value, const std::string& name) {
        const double x = axes.x.at(value);
        svg += line(x, bottom, x, bottom + 5, "#444") + label(x, bottom + 20, "middle", name);
    };
    if (plot.categories.empty()) {
        for (const double value : axes.x.ticks(10)) tick(value, text_of(value));
    }
    for (std::size_t i = 0; i < plot.categories.size(); ++i) tick(static_cast<double>(i), plot.categories[i]);
    return svg + label((axes.x.from + axes.x.to) / 2, bottom + 40, "middle", plot.x_label);
}

std::string draw_y_axes(const Plot& plot, const Axes& axes) {
    std::string svg;
    for (const double value : axes.left.ticks(8)) {
        const double y = axes.left.at(value);
        svg += line(axes.x.from, y, axes.x.to, y, "#ddd") + label(axes.x.from - 8, y + 4, "end", text_of(value));
    }
    const double middle = (axes.left.from + axes.left.to) / 2;
    svg += line(axes.x.from, axes.left.from, axes.x.from, axes.left.to, "#444") +
           label(22, middle, "middle", plot.y_label, upright(22, middle));
    if (!axes.has_right) return svg;
    for (const double value : axes.right.ticks(8)) {
        const double y = axes.right.at(value);
        svg += line(axes.x.to, y, axes.x.to + 5, y, "#444") + label(axes.x.to + 8, y + 4, "start", text_of(value));
    }
    const double edge = plot.width_px - 16;
    return svg + line(axes.x.to, axes.right.from, axes.x.to, axes.right.to, "#444") +
           label(edge, middle, "middle", plot.right_label, upright(edge, middle));
}

std::string draw_line(const Series& series, const Axes& axes, const char* colour) {
    std::string path;
    bool is_drawing = false;
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        const bool is_shown = axes.x.holds(series.x[i]) && axes.y(series).holds(series.y[i]);
        if (is_shown) {
            path += (is_drawing ? " L" : " M") + px(axes.x.at(series.x[i])) + " " + px(axes.y(series).at(series.y[i]));
        }
        is_drawing = is_shown;
    }
    const std::string dashes = series.axis == PlotAxis::Right ? " stroke-dasharray=\"6 4\"" : "";
    return "<path fill=\"none\" stroke-width=\"2\" stroke=\"" + std::string(colour) + "\"" + dashes + " d=\"" + path +
           "\"/>\n";
}

// The bars of one series: the i'th of `count` side by side at each x.
std::string draw_bars(const Series& series, const Axes& axes, const char* colour, int i, int count) {
    std::string svg;
    const double step = 0.8 / count;
    const Scale& scale = axes.y(series);
    const double base = scale.at(scale.is_logarithmic ? scale.low : std::max(0.0, scale.low));
    for (std::size_t k = 0; k < series.x.size(); ++k) {
        if (!axes.x.holds(series.x[k]) || !scale.holds(series.y[k])) continue;
        const double from = axes.x.at(series.x[k] - 0.4 + step * i), to = axes.x.at(series.x[k] - 0.4 + step * (i + 1));
        const double y = scale.at(series.y[k]);
        svg += "<rect x=\"" + px(from) + "\" y=\"" + px(std::min(y, base)) + "\" width=\"" + px(to - from) +
               "\" height=\"" + px(std::abs(base - y)) + "\" fill=\"" + colour + "\"/>\n";
    }
    return svg;
}

std::string draw_legend(const Plot& plot, const Axes& axes) {
    std::string svg;
    const double column = (axes.x.to - axes.x.from) / kLegendColumns;
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const double x = axes.x.from + column * static_cast<double>(i % kLegendColumns);
        const double y = axes.left.from + 64 + kLegendRow * static_cast<double>(i / kLegendColumns);
        svg += "<rect x=\"" + px(x) + "\" y=\"" + px(y - 6) + "\" width=\"22\" height=\"4\" fill=\"" +
               kColours[i % kColours.size()] + "\"/>\n" + label(x + 28, y, "start", plot.series[i].name);
    }
    return svg;
}

std::string draw_series(const Plot& plot, const Axes& axes) {
    const auto is_bars = [](const Series& s) { return s.style == SeriesStyle::Bars; };
    const int count = static_cast<int>(std::ranges::count_if(plot.series, is_bars));
    int bars = 0;
    std::string svg;
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const Series& series = plot.series[i];
        SELVEDGE_ASSERT(series.x.size() == series.y.size());
        const char* colour = kColours[i % kColours.size()];
        svg += is_bars(series) ? draw_bars(series, axes, colour, bars++, count) : draw_line(series, axes, colour);
    }
    return svg;
}

}  // namespace

Plot plot_of(const Figure& figure) {
    const Table& table = figure.series;
    constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
    const auto values = [&](std::size_t column) {
        std::vector<double> numbers;
        for (const std::vector<Cell>& row : table.rows)
            numbers.push_back(row[column].is_number() ? row[column].to_json().number() : kGap);
        return numbers;
    };
    Plot plot{.title = table.name + ": " + table.title,
              .x_label = table.columns.front(),
              .y_label = figure.y_label,
              .right_label = figure.right_column,
              .is_logarithmic = figure.is_logarithmic,
              .is_y_logarithmic = figure.is_y_logarithmic};
    for (std::size_t i = 1; i < table.columns.size(); ++i) {
        const auto is_text = [&](const std::vector<Cell>& row) { return !row[i].is_number() && !row[i].is_empty(); };
        if (std::ranges::any_of(table.rows, is_text)) continue;
        plot.series.push_back({.name = table.columns[i],
                               .x = values(0),
                               .y = values(i),
                               .axis = table.columns[i] == figure.right_column ? PlotAxis::Right : PlotAxis::Left});
    }
    return plot;
}

std::vector<double> tick_values(double low, double high, int count) {
    SELVEDGE_ASSERT(low < high && std::isfinite(high - low) && count >= 1);
    const double rough = (high - low) / count;
    const double power = std::pow(10, std::floor(std::log10(rough)));
    const double digit = rough / power;
    const double step = power * (digit <= 1 ? 1 : digit <= 2 ? 2 : digit <= 5 ? 5 : 10);
    const double first = std::ceil(low / step - 1e-9) + 0.0, last = std::floor(high / step + 1e-9);
    std::vector<double> values;
    for (double k = first; k <= last; ++k) values.push_back(k * step);
    return values;
}

std::string to_svg(const Plot& plot) {
    const Axes axes = axes_of(plot);
    const std::string width = std::to_string(plot.width_px), height = std::to_string(plot.height_px);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
           "\" viewBox=\"0 0 " + width + " " + height + "\" font-family=\"sans-serif\" font-size=\"13\">\n" +
           "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n" +
           label(plot.width_px / 2.0, 26, "middle", plot.title, " font-size=\"16\"") + draw_y_axes(plot, axes) +
           draw_x_axis(plot, axes) + draw_series(plot, axes) + draw_legend(plot, axes) + "</svg>\n";
}

}  // namespace selvedge::bench
