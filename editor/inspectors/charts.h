#pragma once
// Small charts: bars and lines that show a shape, with the figure in words beside it.
#include <functional>
#include <string>
#include <vector>

#include "editor/inspectors/inspector_context.h"

namespace selvedge {

// One bar for each figure, from the left, its number below; the tip tells each figure.
struct BarChart {
    std::vector<int> figures;
    std::function<std::string(std::size_t bar)> tip;
    std::function<Rgb8(std::size_t bar)> colour;
};
void bar_chart(const InspectorContext& context, const BarChart& chart);

// The last figures, the newest at the right, from 0 up. `count` of at most `full`: so many fill the width.
struct SparkLine {
    std::size_t count = 0;
    std::size_t full = 1;
    std::function<float(std::size_t index)> figure;
    std::string tip;
};
void spark_line(const InspectorContext& context, const SparkLine& line);

}  // namespace selvedge
