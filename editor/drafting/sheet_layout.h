#pragma once
// Where panels lie on the drafting sheet that were never put anywhere: side by side in rows, in their order.
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge {

// The origin of each panel on the sheet, m: sheet_position where there is one. No two that are laid out overlap.
std::vector<Vec2d> sheet_positions(const Pattern& pattern);

}  // namespace selvedge
