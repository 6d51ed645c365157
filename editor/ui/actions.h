#pragma once
// The table of all actions, in menu order, and how to run one.
#include <vector>

#include "editor/ui/action.h"

namespace selvedge::editor {

std::vector<Action> make_actions(KeyMap map = KeyMap::Selvedge);

// Keys and menus follow the key map from the next frame on. The choice is kept for the next start.
void save_settings(AppState& state);  // for the next start
void choose_key_map(AppState& state, KeyMap map);

// The titles of the menus, in the order of the menu bar.
std::vector<std::string> menu_names();

// Runs the action if it is enabled. Returns false if it is not.
bool run_action(AppState& state, const Action& action);

// Actions on the selected panels, points and seams.

void add_panel_actions(std::vector<Action>& actions);

// Actions that find and name panels, and hide and lock them.

void add_object_actions(std::vector<Action>& actions);

// Actions of the View menu: views, show modes, parts of the window, interface scale.

void add_view_actions(std::vector<Action>& actions);

}  // namespace selvedge::editor
