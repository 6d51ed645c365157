// Plots as SVG: axes, units, legend, lines with gaps, bars.
#include <gtest/gtest.h>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "bench/support/plot.h"

namespace selvedge::bench {
namespace {

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// The attribute `name` of the k'th element that starts with `start`.
double attribute(const std::string& svg, const std::string& start, std::size_t k, const std::string& name) {
    std::size_t at = svg.find(start);
    for (; k > 0 && at != std::string::npos; --k) at = svg.find(start, at + 1);
    const std::string key = " " + name + "=\"";
    at = svg.find(key, at);
    return std::stod(svg.substr(at + key.size()));
}

Plot two_lines() {
    return {.title = "Drop",
            .x_label = "time, s",
            .y_label = "ms",
            .series = {{.name = "steps", .x = {0, 1, 2}, .y = {0, 10, 20}},
                       {.name = "leaves", .x = {0, 1, 2}, .y = {32, 64, 128}, .axis = PlotAxis::Right}},
            .right_label = "triangles"};
}

TEST(Plot, ticks_are_round_values_within_the_range) {
    EXPECT_EQ(tick_values(0, 10, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
    EXPECT_EQ(tick_values(-1, 1, 4), (std::vector<double>{-1, -0.5, 0, 0.5, 1}));
    EXPECT_EQ(tick_values(130, 170, 4), (std::vector<double>{130, 140, 150, 160, 170}));
}

TEST(Plot, shows_title_labels_with_units_and_a_legend_of_every_series) {
    const std::string svg = to_svg(two_lines());
    for (const char* text : {">Drop<", ">time, s<", ">ms<", ">triangles<", ">steps<", ">leaves<"})
        EXPECT_TRUE(has(svg, text)) << text;
    EXPECT_EQ(count_of(svg, "<path"), 2U);
    EXPECT_FALSE(has(svg, ">-0<"));
    EXPECT_EQ(svg.rfind("<svg ", 0), 0U);
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
}

TEST(Plot, a_right_axis_has_its_own_scale) {
    Plot plot = two_lines();
    EXPECT_TRUE(has(to_svg(plot), ">120<"));
    plot.series[1].axis = PlotAxis::Left;
    plot.right_label.clear();
    const std::string left = to_svg(plot);
    EXPECT_FALSE(has(left, ">triangles<"));
    EXPECT_FALSE(has(left, ">18<"));  // a step of 2, which the axis of the steps alone had
}

TEST(Plot, a_value_that_is_not_finite_leaves_a_gap) {
    Plot plot = two_lines();
    EXPECT_EQ(count_of(to_svg(plot), " M"), 2U);
    plot.series[0].x.push_back(3);
    plot.series[0].y = {0, std::numeric_limits<double>::quiet_NaN(), 20, 30};
    plot.series[1].x.push_back(3);
    plot.series[1].y.push_back(128);
    const std::string svg = to_svg(plot);
    EXPECT_EQ(count_of(svg, " M"), 3U);
    EXPECT_FALSE(has(svg, "nan"));
}

TEST(Plot, a_logarithmic_axis_has_a_tick_at_each_power_of_ten_and_leaves_out_zero) {
    const std::string svg = to_svg({.x_label = "triangles",
                                    .y_label = "us",
                                    .series = {{.name = "new", .x = {0, 10, 1000}, .y = {5, 0.2, 80}}},
                                    .is_logarithmic = true});
    for (const char* text : {">0.1<", ">1<", ">10<", ">100<", ">1000<"}) EXPECT_TRUE(has(svg, text)) << text;
    EXPECT_FALSE(has(svg, "nan"));
    EXPECT_FALSE(has(svg, "inf"));
}

TEST(Plot, y_alone_may_be_logarithmic) {
    const std::string svg = to_svg({.series = {{.name = "a", .x = {0, 3}, .y = {0.5, 80}}}, .is_y_logarithmic = true});
    for (const char* text : {">0.1<", ">1<", ">10<", ">100<", ">0<", ">3<"}) EXPECT_TRUE(has(svg, text)) << text;
}

TEST(Plot, bars_stand_side_by_side_at_named_places_with_heights_in_proportion) {
    const std::string svg = to_svg({.y_label = "us",
                                    .series = {{.name = "pool", .x = {0, 1}, .y = {1, 2}, .style = SeriesStyle::Bars},
                                               {.name = "new", .x = {0, 1}, .y = {4, 8}, .style = SeriesStyle::Bars}},
                                    .categories = {"split", "rejoin"}});
    EXPECT_TRUE(has(svg, ">split<"));
    EXPECT_TRUE(has(svg, ">rejoin<"));
    // The first rectangle is the background; the legend's follow the bars.
    const double pool = attribute(svg, "<rect", 1, "height"), least = attribute(svg, "<rect", 3, "height");
    EXPECT_NEAR(least / pool, 4, 0.02);
    const double pool_end = attribute(svg, "<rect", 1, "x") + attribute(svg, "<rect", 1, "width");
    EXPECT_NEAR(pool_end, attribute(svg, "<rect", 3, "x"), 0.15);
}

TEST(Plot, of_a_figure_draws_each_column_of_numbers_over_the_first) {
    Figure figure{
        .series = {.name = "3.25", .title = "Drop", .columns = {"time, s", "update, ms", "what", "triangles"}},
        .y_label = "ms",
        .right_column = "triangles"};
    figure.series.add_row({Cell(0.5, 1), Cell(2.5, 1), "falls", 32});
    figure.series.add_row({Cell(1.0, 1), Cell(), "rests", 128});
    const Plot plot = plot_of(figure);
    EXPECT_EQ(plot.title, "3.25: Drop");
    EXPECT_EQ(plot.x_label, "time, s");
    ASSERT_EQ(plot.series.size(), 2U);
    EXPECT_EQ(plot.series[0].name, "update, ms");
    EXPECT_EQ(plot.series[0].x, (std::vector<double>{0.5, 1}));
    EXPECT_EQ(plot.series[0].y[0], 2.5);
    EXPECT_TRUE(std::isnan(plot.series[0].y[1]));
    EXPECT_EQ(plot.series[1].axis, PlotAxis::Right);
    EXPECT_EQ(plot.series[1].y, (std::vector<double>{32, 128}));
}

TEST(Plot, text_is_escaped_and_nothing_to_draw_is_still_a_picture) {
    const std::string svg = to_svg({.title = "a < b & \"c\""});
    EXPECT_TRUE(has(svg, "a &lt; b &amp; &quot;c&quot;"));
    EXPECT_FALSE(has(svg, "nan"));
    const std::string flat = to_svg({.series = {{.name = "one", .x = {1}, .y = {0}}}});
    EXPECT_FALSE(has(flat, "nan"));
}

}  // namespace
}  // namespace selvedge::bench
