#pragma once
// Actions that change what is seen: views, modes, parts of the window, the interface's size.
#include <vector>

#include "editor/ui/action.h"

namespace selvedge {

void add_view_actions(std::vector<Action>& actions);

}  // namespace selvedge
