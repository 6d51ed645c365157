#pragma once
// Panels on the sheet: cloth, outline, grainline, name, internal lines, notches, pins, and what of them is selected.
#include <string>
#include <vector>

#include "editor/sheet/sheet_pen.h"
#include "editor/tools/tool_host.h"

namespace selvedge::editor {

// Beneath seams.
void draw_cloth(const SheetLook& look, const PanelShape& shape);
void draw_outline(const SheetLook& look, const PanelShape& shape);

// Above them.
void draw_marks(const SheetLook& look, const PanelShape& shape);
void draw_selected(const SheetLook& look, const PanelShape& shape);

// Of Hover and Selection: edges and vertices that are pointed to.
void draw_hovered(const SheetLook& look);

// Seams on the sheet: both sides in one colour, ticks and a triangle that show how they meet, uneven ones in red.

void draw_seams(const SheetLook& look);

// A line inside of a run of px points, `inset` to its left in the sheet, shortened at both ends.
std::vector<ImVec2> inset_line(std::span<const ImVec2> line, float inset, float trim);

// What the tool wants seen, what is typed, and the places of an error.

void draw_overlay(const SheetLook& look);
void draw_lit_places(const SheetLook& look, const std::vector<GeometryPlace>& places);

// Beside the cursor: what is typed, in large, and the tool's readout. `cursor` in px.
void draw_bubble(const SheetPen& pen, const Vec2d& cursor, const ToolOverlay& overlay, const TypedInput& typed);

}  // namespace selvedge::editor
