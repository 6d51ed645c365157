#pragma once
// The bars about the views: menus above, questions below them, tools at the left, the status line at the bottom.

namespace selvedge {

struct Desk;

void show_menu_bar(Desk& desk);

// m px of the height that questions take; 0: nothing is asked.
float show_question(Desk& desk);

// px of the width that the tools take in that height: where they do not fit below each other, more columns.
float tool_bar_width(float height);

void show_tool_bar(Desk& desk);
void show_status_bar(Desk& desk);

// Above the 3D view: start, reset, what is shown.
void show_fitting_bar(Desk& desk);

}  // namespace selvedge
