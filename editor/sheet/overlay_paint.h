#pragma once
// What the tool wants seen, what is typed, and the places of an error.
#include <string>
#include <vector>

#include "editor/sheet/sheet_look.h"
#include "editor/tools/tool_host.h"

namespace selvedge {

void draw_overlay(const SheetLook& look);
void draw_lit_places(const SheetLook& look, const std::vector<DraftPlace>& places);

// Beside the cursor: what is typed, in large, and the tool's readout. `cursor` in px.
void draw_bubble(const SheetPen& pen, const Vec2d& cursor, const ToolOverlay& overlay, const TypedInput& typed);

}  // namespace selvedge
