#pragma once
// The bars about the views: menus above, questions below them, tools at the left, the status line at the bottom.

namespace selvedge::editor {

struct AppState;

void show_menu_bar(AppState& desk);

// m px of the height that questions take; 0: nothing is asked.
float show_question(AppState& desk);

// px of the width that the tools take in that height: where they do not fit below each other, more columns.
float tool_bar_width(float height);

void show_tool_bar(AppState& desk);
void show_status_bar(AppState& desk);

// Above the 3D view: start, reset, what is shown.
void show_viewport_bar(AppState& desk);

// What a right click on the sheet offers: the actions that can be done with what is selected.

struct AppState;

// Opens it at the cursor; what lies under the cursor is selected first unless it is already.
void open_sheet_menu(AppState& desk);

// Each frame: shows it as long as it is open.
void show_sheet_menu(AppState& desk);

// What a person sees first: three examples, the files of last time, the keys that matter most.

struct AppState;

void show_start_page(AppState& desk);

}  // namespace selvedge::editor
