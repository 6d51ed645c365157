#pragma once
// What the layers of pattern programs mean, by number (ANSI/AAMA-292 and ASTM D6673) or by a word in their names.
#include <string_view>

#include "sim/paper/drawing.h"

namespace selvedge::sim {

inline constexpr int kBoundaryLayer = 1, kTurnLayer = 2, kNotchLayer = 4, kFoldLayer = 6, kGrainLayer = 7,
                     kInternalLayer = 8, kCutoutLayer = 11, kDrillLayer = 13, kSewLayer = 14, kAnnotationLayer = 15;

// The number of a layer; words that other programs use stand for it; -1: neither.
int dxf_layer_number(std::string_view name);

bool is_notch_layer(int layer);
bool is_quality_layer(int layer);  // 84 to 87: curves that repeat what other layers draw

NotchKind notch_of_layer(int layer);

// Help for layers that have no meaning.
LineKind kind_of_layer(int layer);

}  // namespace selvedge::sim
