#include "sim/paper/drawing_unit.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <span>

#include "sim/core/error.h"
#include "sim/paper/path_builder.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

constexpr std::array kUnits = std::to_array<DrawingUnit>({{"mm", "mm", 0.001},
                                                          {"cm", "cm", 0.01},
                                                          {"in", "inch", 0.0254},
                                                          {"px", "px (96 to the inch)", 0.0254 / 96},
                                                          {"pt", "pt (72 to the inch)", 0.0254 / 72},
                                                          {"m", "m", 1}});

constexpr double kSmallest = 0.25, kLargest = 1.8;  // m, of a garment's largest panel

}  // namespace

double size_of(const DrawnPath& path) {
    Eigen::AlignedBox2d box;
    const Panel shape = as_panel(path);
    for (const OutlineEdge& edge : shape.edges) {
        constexpr int kSteps = 8;
        for (int i = 0; i <= kSteps; ++i) box.extend(outline_point(shape, edge, i / double(kSteps)));
    }
    return box.isEmpty() ? 0 : box.sizes().maxCoeff();
}

double metres_of_unit(const std::string& option) {
    const auto found = std::ranges::find_if(kUnits, [&](const DrawingUnit& unit) { return option == unit.option; });
    if (found == kUnits.end()) throw InputError("", "--unit", "'" + option + "' is none of mm, cm, m, in, pt, px");
    return found->metres;
}

DrawingUnit guess_unit(const Drawing& drawing) {
    double largest = 0;
    for (const DrawnPart& part : drawing.parts) {
        for (const DrawnPath& path : part.paths) {
            if (path.is_closed && path.kind != LineKind::Help) largest = std::max(largest, size_of(path));
        }
    }
    const std::span<const DrawingUnit> units =
        drawing.likely_units.empty() ? std::span<const DrawingUnit>(kUnits) : drawing.likely_units;
    for (const DrawingUnit& unit : units) {
        if (largest * unit.metres >= kSmallest && largest * unit.metres <= kLargest) return unit;
    }
    return units.front();
}

std::string doubt_of_size(double largest, double metres_per_unit) {
    if (largest >= kSmallestLargest && largest <= kLargestLargest) return {};
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(), "the largest part is %.3g cm long: no garment is so %s", 100 * largest,
                  largest < kSmallestLargest ? "small" : "large");
    std::string doubt = text.data();
    for (const DrawingUnit& unit : kUnits) {
        const double length = largest / metres_per_unit * unit.metres;
        if (length < kSmallest || length > kLargest) continue;
        std::snprintf(text.data(), text.size(), "; --unit %s would make it %.3g cm", unit.option, 100 * length);
        return doubt + text.data();
    }
    return doubt;
}

}  // namespace selvedge::sim
