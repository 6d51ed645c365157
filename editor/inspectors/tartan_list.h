#pragma once
// Tartans to choose from, each with a woven picture, and a threadcount of one's own.
#include "editor/inspectors/inspector_context.h"

namespace selvedge {

// The search box, the list that fits it; a click on one takes it.
void draw_tartan_list(InspectorContext& context);

// The threadcount, with what it weaves, also while it is typed, and what is wrong with it in words.
void draw_threadcount(InspectorContext& context);

}  // namespace selvedge
