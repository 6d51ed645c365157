#include "editor/ui/sheet_menu.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "editor/ui/actions.h"
#include "editor/ui/desk.h"
#include "editor/ui/widgets.h"

namespace selvedge {
namespace {

constexpr const char* kName = "##sheet_menu";
constexpr std::array<std::string_view, 3> kMenus{"Edit", "Panel", "Seam"};

// A right click on a thing that is not selected means that thing. A seam is meant before the edge that it lies on.
void select_under_cursor(Desk& desk) {
    const Hover& hover = desk.workspace.hover;
    const Selection& selected = desk.workspace.document->selection();
    Selection wanted;
    if (hover.seam && !selected.seams.contains(*hover.seam)) {
        wanted.seams.insert(*hover.seam);
    } else if (!hover.seam && !hover.panel.empty() && !selected.panels.contains(hover.panel) &&
               selected.edges.empty() && selected.vertices.empty()) {
        wanted.panels.insert(hover.panel);
    } else {
        return;
    }
    desk.workspace.document->select(wanted);
}

void show_entry(Desk& desk, const Action& action) {
    if (ImGui::MenuItem(action.title.c_str(), chord_words(action).c_str())) run_action(desk, action);
    note_widget(desk.widgets, "sheet_menu." + action.id);
    tip(action.tip);
}

}  // namespace

void open_sheet_menu(Desk& desk) {
    select_under_cursor(desk);
    ImGui::OpenPopup(kName);
}

void show_sheet_menu(Desk& desk) {
    if (!ImGui::BeginPopup(kName)) return;
    bool has_group = false;
    for (const std::string_view menu : kMenus) {
        bool has_any = false;
        for (const Action& action : desk.actions) {
            if (action.menu != menu || (action.can && !action.can(desk))) continue;
            if (!has_any && has_group) ImGui::Separator();
            has_any = true;
            show_entry(desk, action);
        }
        has_group = has_group || has_any;
    }
    ImGui::EndPopup();
}

}  // namespace selvedge
