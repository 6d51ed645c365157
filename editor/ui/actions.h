#pragma once
// The table of all actions, in the order of their menus.
#include <vector>

#include "editor/ui/action.h"

namespace selvedge {

std::vector<Action> make_actions();

// The menus of the bar, in their order.
std::vector<std::string> menu_names();

// Runs it, where it can be run now. False: it cannot.
bool run_action(Desk& desk, const Action& action);

}  // namespace selvedge
