#include "sim/paper/drawing_unit.h"

#include <algorithm>
#include <array>

#include "sim/paper/path_builder.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

constexpr std::array kUnits = std::to_array<DrawingUnit>({{"mm", 0.001},
                                                          {"cm", 0.01},
                                                          {"inch", 0.0254},
                                                          {"px (96 to the inch)", 0.0254 / 96},
                                                          {"pt (72 to the inch)", 0.0254 / 72},
                                                          {"m", 1}});

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

DrawingUnit guess_unit(const Drawing& drawing) {
    constexpr double kSmallest = 0.25, kLargest = 1.8;  // m, of a garment's largest panel
    double largest = 0;
    for (const DrawnPart& part : drawing.parts) {
        for (const DrawnPath& path : part.paths) {
            if (path.is_closed && path.kind != LineKind::Help) largest = std::max(largest, size_of(path));
        }
    }
    for (const DrawingUnit& unit : kUnits) {
        if (largest * unit.metres >= kSmallest && largest * unit.metres <= kLargest) return unit;
    }
    return kUnits[0];
}

}  // namespace selvedge::sim
