#pragma once
// Draws the content of the sheet: panels (cloth, outline, grainline, name, internal lines, notches, pins), seams, the
// selection, and the tool's overlay.
#include <string>
#include <vector>

#include "editor/sheet/sheet_labels.h"
#include "editor/sheet/sheet_pen.h"
#include "editor/tools/tool_host.h"

namespace selvedge::editor {

// Drawn below the seams.
void draw_cut_line(const SheetLook& look, const PanelShape& shape);  // with its notches; nothing without allowance
void draw_cloth(const SheetLook& look, const PanelShape& shape);
void draw_outline(const SheetLook& look, const PanelShape& shape);

// Drawn above the seams.
void draw_marks(const SheetLook& look, const PanelShape& shape, const PanelName& name);
void draw_selected(const SheetLook& look, const PanelShape& shape);
void draw_lengths(const SheetLook& look, const PanelShape& shape);  // beside the edges, outside

// Draws the hovered edge and vertex.
void draw_hovered(const SheetLook& look);

// Seams on the sheet: both sides in one colour; ticks and a triangle show the direction in which they meet; sides of
// unequal length are red. Those of hidden panels are left out.

void draw_seams(const SheetLook& look);

// A copy of the polyline (px), offset to its left on the sheet by `inset` px and shortened at both ends by `trim` px.
std::vector<ImVec2> inset_line(std::span<const ImVec2> line, float inset, float trim);

// The tool's overlay and the parts that a message names.

void draw_overlay(const SheetLook& look);
void draw_lit_places(const SheetLook& look, const std::vector<PartLocation>& places);
void draw_lit_cloth(const SheetLook& look, const std::vector<LitCloth::OnPanel>& lines);  // a point is ringed

// px, the upper left corner of a box beside the cursor: below and to the right of it; on the other side where it would
// leave the view; in the view where neither side has room. `beside`: px from the cursor.
ImVec2 bubble_corner(const SheetCamera& camera, const Vec2d& cursor, const Vec2d& size, double beside);

// Shows the typed text in large letters and the tool's problem and readout beside the cursor. `cursor` in px.
void draw_bubble(const SheetPen& pen, const Vec2d& cursor, const ToolOverlay& overlay, const ToolHost& tools);

}  // namespace selvedge::editor
