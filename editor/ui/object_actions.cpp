// Actions that find and name panels, and hide and lock them.
#include <set>
#include <string>
#include <vector>

#include "editor/geometry/sewing.h"
#include "editor/tools/select_tool.h"
#include "editor/ui/actions.h"
#include "editor/ui/app_state.h"

namespace selvedge::editor {
namespace {

// Opens the tab Objects.
ObjectsState& show_objects(AppState& state) {
    state.layout.has_inspectors = true;
    if (state.layout.tab != InspectorTab::Objects) state.layout.wanted_tab = InspectorTab::Objects;
    return state.inspectors.objects;
}

// Panels that are selected, or have a selected part.
void set_aside(AppState& state, std::set<std::string> PanelStates::*which) {
    PanelStates states = state.workspace.document->panel_states();
    (states.*which).merge(touched_panels(state.workspace.document->selection()));
    state.workspace.document->set_panel_states(states);
}

void set_none_aside(AppState& state, std::set<std::string> PanelStates::*which) {
    PanelStates states = state.workspace.document->panel_states();
    (states.*which).clear();
    state.workspace.document->set_panel_states(states);
}

bool touches_panels(const AppState& state) {
    return !touched_panels(state.workspace.document->selection()).empty();
}

bool may_be_named(const AppState& state) {
    const Selection& selection = state.workspace.document->selection();
    return selection.panels.size() == 1 ||
           (selection.panels.empty() &&
            one_of_each_sewing(state.workspace.document->pattern(), selection.seams).size() == 1);
}

void add_names(std::vector<Action>& actions) {
    actions.push_back(
        {.id = "panel.find",
         .menu = "Panel",
         .title = "Find panel...",
         .tip = "By its name, in the list of objects; seams and lines, too",
         .chords = {{key_of('F'), {.ctrl = true}}},
         .begins_group = true,
         .run = [](AppState& state) { show_objects(state).wants_find = true; },
         .can = [](const AppState& state) { return !state.workspace.document->pattern().panels.empty(); }});
    actions.push_back({.id = "panel.rename",
                       .menu = "Panel",
                       .title = "Rename...",
                       .tip = "The selected panel or seam",
                       .chords = {{Key::F2, {}}},
                       .run = [](AppState& state) { show_objects(state).wants_naming = true; },
                       .can = may_be_named});
}

void add_states(std::vector<Action>& actions) {
    actions.push_back({.id = "panel.hide",
                       .menu = "Panel",
                       .title = "Hide",
                       .tip = "On the sheet and in the 3D view; the cloth still drapes",
                       .chords = {{key_of('H'), {.ctrl = true, .shift = true}}},
                       .begins_group = true,
                       .run = [](AppState& state) { set_aside(state, &PanelStates::hidden); },
                       .can = touches_panels});
    actions.push_back(
        {.id = "panel.show_all",
         .menu = "Panel",
         .title = "Show all",
         .run = [](AppState& state) { set_none_aside(state, &PanelStates::hidden); },
         .can = [](const AppState& state) { return !state.workspace.document->panel_states().hidden.empty(); }});
    actions.push_back({.id = "panel.lock",
                       .menu = "Panel",
                       .title = "Lock",
                       .tip = "Neither the sheet nor the 3D view picks or changes it",
                       .chords = {{key_of('L'), {.ctrl = true, .shift = true}}},
                       .run = [](AppState& state) { set_aside(state, &PanelStates::locked); },
                       .can = touches_panels});
    actions.push_back(
        {.id = "panel.unlock_all",
         .menu = "Panel",
         .title = "Unlock all",
         .run = [](AppState& state) { set_none_aside(state, &PanelStates::locked); },
         .can = [](const AppState& state) { return !state.workspace.document->panel_states().locked.empty(); }});
}

}  // namespace

void add_object_actions(std::vector<Action>& actions) {
    add_names(actions);
    add_states(actions);
}

}  // namespace selvedge::editor
