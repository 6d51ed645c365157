#pragma once
// Panels on the sheet: cloth, outline, grainline, name, internal lines, notches, pins, and what of them is selected.
#include "editor/sheet/sheet_look.h"

namespace selvedge {

// Beneath seams.
void draw_cloth(const SheetLook& look, const PanelShape& shape);
void draw_outline(const SheetLook& look, const PanelShape& shape);

// Above them.
void draw_marks(const SheetLook& look, const PanelShape& shape);
void draw_selected(const SheetLook& look, const PanelShape& shape);

// Of Hover and Selection: edges and vertices that are pointed to.
void draw_hovered(const SheetLook& look);

}  // namespace selvedge
