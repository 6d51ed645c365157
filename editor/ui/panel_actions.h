#pragma once
// Actions on what is selected: panels, points, seams.
#include <vector>

#include "editor/ui/action.h"

namespace selvedge {

void add_panel_actions(std::vector<Action>& actions);

}  // namespace selvedge
