#pragma once
// Seams on the sheet: both sides in one colour, ticks and a triangle that show how they meet, uneven ones in red.
#include "editor/sheet/sheet_look.h"

namespace selvedge {

void draw_seams(const SheetLook& look);

// A line inside of a run of px points, `inset` to its left in the sheet, shortened at both ends.
std::vector<ImVec2> inset_line(std::span<const ImVec2> line, float inset, float trim);

}  // namespace selvedge
