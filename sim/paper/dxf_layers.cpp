#include "sim/paper/dxf_layers.h"

#include <array>
#include <charconv>
#include <string>
#include <utility>

#include "sim/core/lower_case.h"

namespace selvedge::sim {

int dxf_layer_number(std::string_view name) {
    const std::string small = lower_case(name);
    std::string_view digits = small;
    for (const std::string_view prefix : {"layer_", "layer-", "layer"}) {
        if (digits.starts_with(prefix)) digits.remove_prefix(prefix.size());
    }
    int number = -1;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error == std::errc() && stop == digits.data() + digits.size()) return number;
    constexpr std::array<std::pair<std::string_view, int>, 17> words{{{"cutout", kCutoutLayer},
                                                                      {"cut-out", kCutoutLayer},
                                                                      {"allowance", kBoundaryLayer},
                                                                      {"cut", kBoundaryLayer},
                                                                      {"boundary", kBoundaryLayer},
                                                                      {"outline", kBoundaryLayer},
                                                                      {"contour", kBoundaryLayer},
                                                                      {"sew", kSewLayer},
                                                                      {"stitch", kSewLayer},
                                                                      {"seam", kSewLayer},
                                                                      {"notch", kNotchLayer},
                                                                      {"grain", kGrainLayer},
                                                                      {"mirror", kFoldLayer},
                                                                      {"fold", kFoldLayer},
                                                                      {"drill", kDrillLayer},
                                                                      {"internal", kInternalLayer},
                                                                      {"text", kAnnotationLayer}}};
    for (const auto& [word, layer] : words) {
        if (small.find(word) != std::string::npos) return layer;
    }
    return -1;
}

bool is_notch_layer(int layer) {
    return layer == kNotchLayer || (layer >= 80 && layer <= 83);
}

bool is_quality_layer(int layer) {
    return layer >= 84 && layer <= 87;
}

NotchKind notch_of_layer(int layer) {
    return layer == 80   ? NotchKind::T
           : layer == 81 ? NotchKind::Castle
           : layer == 82 ? NotchKind::V
           : layer == 83 ? NotchKind::U
                         : NotchKind::Slit;
}

LineKind kind_of_layer(int layer) {
    if (layer == kFoldLayer) return LineKind::FoldEdge;
    if (layer == kGrainLayer) return LineKind::Grain;
    if (layer == kInternalLayer) return LineKind::Internal;
    if (layer == kCutoutLayer) return LineKind::Cutout;
    return LineKind::Help;
}

}  // namespace selvedge::sim
