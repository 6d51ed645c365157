#pragma once
// The bars around the views: menu bar, questions, status line, the bar above the 3D view; also the context menu
// of the sheet and the start page.

namespace selvedge::editor {

struct AppState;

void show_menu_bar(AppState& state);

// Shows the first open question. Returns the height of the bar, px; 0: there is no question.
float show_question(AppState& state);

void show_status_bar(AppState& state);

// Above the 3D view: start, reset, show modes, switches. In a narrow view it has several rows.
void show_viewport_bar(AppState& state);

// The height of its rows in a window whose content is `width` px wide, px.
float viewport_bar_height(float width);

// The context menu of the sheet: the actions that apply to the selection.

// Opens the menu at the cursor. Selects what is under the cursor first, unless it is already selected.
void open_sheet_menu(AppState& state);

// Call each frame: shows the menu while it is open.
void show_sheet_menu(AppState& state);

// The start page: three examples, the recent files, the most important keys.

void show_start_page(AppState& state);

}  // namespace selvedge::editor
