#pragma once
// The tool bar: the sheet's tools as icons, in groups with a line between them and, where there is room, a caption. In
// a low window it has two columns; in a still lower one it scrolls.

namespace selvedge::editor {

struct AppState;

// The width of the tool bar at this height, px.
float tool_bar_width(float height);

// Fills the current window.
void show_tool_bar(AppState& state);

}  // namespace selvedge::editor
