#pragma once
// Commands for menu entries and shortcuts that act on the sheet's selection. Each function returns no command if it
// does not apply.
#include <vector>

#include "editor/document/command.h"
#include "editor/tools/sheet_geometry.h"

namespace selvedge::editor {

enum class MirrorAxis {
    Upright,  // vertical axis: left becomes right
    Level     // horizontal axis: top becomes bottom
};

// Mirrors in place, over an axis through the centre of the selection's bounding box.
std::vector<Command> mirror_selected(const SheetGeometry& geometry, const Selection& selection, MirrorAxis axis);

// Rotates counter-clockwise about the centre of the selection's bounding box; rad.
std::vector<Command> rotate_selected(const SheetGeometry& geometry, const Selection& selection, double angle);

// Copies are placed to the right of all panels on the sheet, so that nothing overlaps.
std::vector<Command> duplicate_selected(const SheetGeometry& geometry, const Selection& selection);
std::vector<Command> symmetric_copy_selected(const SheetGeometry& geometry, const Selection& selection);

std::vector<Command> unlink_selected(const SheetGeometry& geometry, const Selection& selection);
std::vector<Command> reverse_selected_seams(const Selection& selection);

}  // namespace selvedge::editor
