#pragma once
// The timeline of the body's motion, under the 3D view: its time, to be dragged, and how it is played.

namespace selvedge::editor {

struct AppState;

float timeline_height();  // px

// Draws into the current ImGui window.
void show_timeline(AppState& state);

}  // namespace selvedge::editor
