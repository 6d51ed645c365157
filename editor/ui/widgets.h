#pragma once
// Small controls that several parts of the interface share. Those that have a name note where they stand.
#include <string>

#include "editor/frame/widget_map.h"
#include "sim/tartan/sett.h"

namespace selvedge {

struct Action;
struct Desk;

// Notes where the last item stands.
void note_widget(WidgetMap& widgets, const std::string& name);

// A tooltip for the last item.
void tip(const std::string& words);

bool button(Desk& desk, const std::string& name, const std::string& label);

// A square with the action's picture; pressed in while it is on.
void icon_button(Desk& desk, const Action& action, const std::string& icon, float side_px);

// One action in a list: its title, its menu, its key.
bool action_row(Desk& desk, const Action& action, bool is_chosen);

void coloured_text(const Rgb8& colour, const std::string& words);

}  // namespace selvedge
