#pragma once
// The sheet's paper: grid, and rulers along its top and left edge.
#include <optional>

#include "editor/sheet/sheet_pen.h"

namespace selvedge {

inline constexpr double kRulerWidth = 30;  // px of the interface: as wide as "-160"

// Lines of 1 mm, 1 cm, 5 cm, 10 cm... by the zoom; finer ones fade in.
void draw_grid(const SheetPen& pen);

// In cm; `cursor` (px) is marked on both.
void draw_rulers(const SheetPen& pen, const std::optional<Vec2d>& cursor);

}  // namespace selvedge
