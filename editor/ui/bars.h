#pragma once
// The bars about the views: menus above, questions below them, tools at the left, the status line at the bottom.

namespace selvedge::editor {

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

// What a right click on the sheet offers: the actions that can be done with what is selected.

struct Desk;

// Opens it at the cursor; what lies under the cursor is selected first unless it is already.
void open_sheet_menu(Desk& desk);

// Each frame: shows it as long as it is open.
void show_sheet_menu(Desk& desk);

// What a person sees first: three examples, the files of last time, the keys that matter most.

struct Desk;

void show_start_page(Desk& desk);

}  // namespace selvedge::editor
