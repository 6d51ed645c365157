#pragma once
// What menus and keys do with what is selected on the sheet, as commands: none where it does not apply.
#include <vector>

#include "editor/document/command.h"
#include "editor/tools/sheet_geometry.h"

namespace selvedge::editor {

enum class MirrorAxis {
    Upright,  // left becomes right
    Level     // top becomes bottom
};

// In place, over the middle of the selection's box.
std::vector<Command> mirror_selected(const SheetGeometry& geometry, const Selection& selection, MirrorAxis axis);

// Counter-clockwise, about the middle; rad.
std::vector<Command> rotate_selected(const SheetGeometry& geometry, const Selection& selection, double angle);

// Beside all that lies on the sheet, so that nothing covers anything.
std::vector<Command> duplicate_selected(const SheetGeometry& geometry, const Selection& selection);
std::vector<Command> symmetric_copy_selected(const SheetGeometry& geometry, const Selection& selection);

std::vector<Command> unlink_selected(const SheetGeometry& geometry, const Selection& selection);
std::vector<Command> reverse_selected_seams(const Selection& selection);

}  // namespace selvedge::editor
