#pragma once
// The pictures on buttons: lines in a square of 16 by 16, drawn at any size, so that they are sharp at every scale.
#include <string_view>

#include "sim/core/vec.h"
#include "sim/tartan/sett.h"

struct ImDrawList;

namespace selvedge {

// By a tool's id or an action's; nothing is drawn for a name that has none.
void draw_icon(ImDrawList& list, std::string_view name, const Vec2f& low, float side_px, const Rgb8& colour);

bool has_icon(std::string_view name);

}  // namespace selvedge
