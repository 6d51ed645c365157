#pragma once
// The table of all actions, in the order of their menus.
#include <vector>

#include "editor/ui/action.h"

namespace selvedge::editor {

std::vector<Action> make_actions();

// The menus of the bar, in their order.
std::vector<std::string> menu_names();

// Runs it, where it can be run now. False: it cannot.
bool run_action(AppState& desk, const Action& action);

// Actions on what is selected: panels, points, seams.

void add_panel_actions(std::vector<Action>& actions);

// Actions that change what is seen: views, modes, parts of the window, the interface's size.

void add_view_actions(std::vector<Action>& actions);

}  // namespace selvedge::editor
