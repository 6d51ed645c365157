// The history inspector: the list of commands, with undo and redo to any of them. Also what all inspectors do once per
// frame.
#include "editor/inspectors/inspectors.h"

#include <imgui.h>

#include "editor/inspectors/body_inspector.h"
#include "editor/inspectors/controls.h"
#include "editor/inspectors/number_box.h"

namespace selvedge::editor {
namespace {

// Returns whether it was clicked.
bool draw_entry(InspectorContext& context, std::size_t position, const std::string& label) {
    const std::size_t present = context.workspace.document->position();
    const bool is_undone = position > present;
    const std::string name = "history." + std::to_string(position);
    const float left = ImGui::GetCursorPosX(), room = ImGui::GetContentRegionAvail().x;
    const bool is_clicked =
        ImGui::Selectable(("##" + name).c_str(), position == present, 0, {room, ImGui::GetTextLineHeight()});
    note_widget(context, name);
    show_tip(is_undone             ? label + "\nUndone. Click to do it again, with all before it."
             : position == present ? label + "\nThe garment as it is now."
                                   : label + "\nClick to go back to here; what follows can be done again.");
    const float mark = 1.1F * ImGui::GetFontSize();
    back_to(left);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 centre(low.x + mark / 3, low.y + ImGui::GetTextLineHeight() / 2);
    const float radius = 0.2F * ImGui::GetFontSize();
    if (position == present) {
        ImGui::GetWindowDrawList()->AddCircleFilled(centre, radius,
                                                    ImGui::GetColorU32(to_colour(context.theme.accent)));
    } else {
        ImGui::GetWindowDrawList()->AddCircle(centre, 0.7F * radius, ImGui::GetColorU32(to_colour(context.theme.line)));
    }
    ImGui::Dummy({mark, ImGui::GetTextLineHeight()});
    ImGui::SameLine(0, 0);
    ImGui::PushStyleColor(ImGuiCol_Text, to_colour(is_undone ? context.theme.faint : context.theme.ink));
    ImGui::TextUnformatted(elided(label, room - mark).c_str());
    ImGui::PopStyleColor();
    return is_clicked;
}

}  // namespace

void draw_history(InspectorContext& context) {
    Document& document = *context.workspace.document;
    ButtonRow row(context);
    if (row.button({.name = "history.undo",
                    .title = "Undo",
                    .tip = with_key(context, "Takes back what was done last", "edit.undo"),
                    .is_enabled = document.can_undo()})) {
        document.undo();
    }
    if (row.button({.name = "history.redo",
                    .title = "Redo",
                    .tip = with_key(context, "Does again what was taken back", "edit.redo"),
                    .is_enabled = document.can_redo()})) {
        document.redo();
    }
    ImGui::Spacing();
    std::optional<std::size_t> wanted;
    if (draw_entry(context, 0, "As it was opened")) wanted = 0;
    for (std::size_t i = 0; i < document.history().size(); ++i) {
        if (draw_entry(context, i + 1, document.history()[i].label)) wanted = i + 1;
    }
    if (wanted) document.go_to(*wanted);
    if (document.history().empty()) paragraph(context, "What you do is listed here, to go back to.");
}

void update_inspectors(InspectorContext& context) {
    context.state.drape.trace.take(*context.workspace.drape.frame());
    update_body_request(context);
    forget_lost_boxes(context);
}

}  // namespace selvedge::editor
