#include "render/figure_legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "render/scene/colour_map.h"
#include "sim/core/assert.h"
#include "sim/core/quantile.h"

namespace selvedge {
namespace {

// Without digits that say nothing: 5, 2.5, 0.15.
std::string short_number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", value);
    return text.data();
}

std::string percent(double strain) {
    std::array<char, 32> text{};
    const double tenths = std::round(1000 * strain);
    std::snprintf(text.data(), text.size(), "%+.1f %%", tenths == 0 ? 0.0 : tenths / 10);
    return text.data();
}

std::string millimetres(double metres) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), std::abs(metres) < 0.00995 ? "%.1f mm" : "%.0f mm", 1000 * metres);
    return text.data();
}

}  // namespace

double round_up(double value) {
    SELVEDGE_ASSERT(value > 0 && std::isfinite(value));
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double step : {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0}) {
        if (value <= step * power * (1 + 1e-6)) return step * power;
    }
    return 10 * power;
}

Legend strain_legend(const std::string& title, double limit, const std::vector<double>& strains) {
    const std::string end = short_number(100 * limit);
    return {.title = title,
            .scale = LegendScale{.map = diverging_map(),
                                 .ticks = {{0, "-" + end + " %"}, {0.5F, "0"}, {1, "+" + end + " %"}}},
            .notes = {{"99th percentile", percent(quantile(strains, 0.99))},
                      {"largest", percent(*std::max_element(strains.begin(), strains.end()))},
                      {"smallest", percent(*std::min_element(strains.begin(), strains.end()))}}};
}

Legend clearance_legend(double limit, const std::vector<double>& clearances) {
    const std::string half = short_number(500 * limit), end = short_number(1000 * limit);
    Legend legend{.title = "Distance from the body",
                  .scale = LegendScale{.map = sequential_map(), .ticks = {{0, "0"}, {0.5F, half}, {1, end + " mm"}}},
                  .notes = {{"median", millimetres(quantile(clearances, 0.5))},
                            {"99th percentile", millimetres(quantile(clearances, 0.99))},
                            {"largest", millimetres(*std::max_element(clearances.begin(), clearances.end()))}}};
    const double least = *std::min_element(clearances.begin(), clearances.end());
    if (least < 0) legend.notes.push_back({"deepest inside", millimetres(-least)});
    return legend;
}

}  // namespace selvedge
