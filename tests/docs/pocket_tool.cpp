#include "tests/docs/pocket_tool.h"

#include "editor/geometry/draft.h"
#include "editor/geometry/panel_edit.h"
#include "editor/tools/draw_tools.h"

namespace selvedge::editor {

// [events]
void PocketTool::hover(ToolContext& context, const SheetPointer& pointer) {
    Tool::hover(context, pointer);
    at_ = snap(context.geometry, pointer.at, snap_options(context, pointer.modifiers)).point;
}

void PocketTool::click(ToolContext& context, const SheetPointer& pointer) {
    drop(context, pointer);
}

void PocketTool::drag(ToolContext& context, const SheetPointer& pointer) {
    hover(context, pointer);
    context.document.preview(command(context));  // replaces the last preview; Escape rolls it back
}

void PocketTool::drop(ToolContext& context, const SheetPointer& pointer) {
    drag(context, pointer);
    context.document.commit();  // one entry of the history
}

bool PocketTool::enter(ToolContext&, const std::vector<double>& numbers) {
    if (numbers.size() != 2) return false;
    size_ = Vec2d(numbers[0], numbers[1]) / 100;
    return true;
}
// [/events]

// [command]
AddPanels PocketTool::command(const ToolContext& context) const {
    if (size_.minCoeff() < 0.01) throw GeometryError("A pocket is at least 1 cm wide and high");
    sim::Panel panel = make_rectangle(-size_ / 2, size_ / 2);
    panel.name = "pocket";
    panel.sheet_position = at_;
    return {{placed_freely(context.document, context.drape, panel)}};
}

void PocketTool::draw(const ToolContext&, ToolOverlay& overlay) const {
    add_box(overlay, SheetBox(at_ - size_ / 2, at_ + size_ / 2), OverlayTone::Draft);
    overlay.readout = {in_cm(size_.x()) + " x " + in_cm(size_.y())};
}

std::string PocketTool::hint(const ToolContext&) const {
    return "Click where the pocket goes, or type width x height (cm), then Enter";
}
// [/command]

// [row]
const ToolInfo kPocket{.id = "pocket",
                       .title = "Pocket",
                       .what = "Put a pocket where you click",
                       .make = make<PocketTool>,
                       .icon = "M3 2 L13 2 L13 10 L8 14 L3 10 Z",
                       .key = key_of('W')};
// [/row]

}  // namespace selvedge::editor
