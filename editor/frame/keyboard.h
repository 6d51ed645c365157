#pragma once
// Dear ImGui's keyboard in terms of our keys, for its versions 1.86 to 1.90.
#include "editor/frame/frame.h"

struct ImGuiIO;

namespace selvedge::editor {

// Tells ImGui which of our keys are those that its own widgets know. Call once per context.
void map_keys(ImGuiIO& io);

void set_key(ImGuiIO& io, Key key, bool is_down);

// Whether the key went down in this frame.
bool is_key_pressed(Key key);

// Also while it is held, at the rate at which keys repeat.
bool is_key_repeated(Key key);

}  // namespace selvedge::editor
