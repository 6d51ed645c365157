#pragma once
// The parts of a plain drawing: closed shapes that lie in no other, with what lies in them. Outlines that are drawn in
// pieces are joined, what is no part is left out, and told.
#include <string>

#include "sim/paper/drawing.h"
#include "sim/paper/plain_drawing.h"

namespace selvedge::sim {

// Adds parts, notes and the unit to a drawing. Throws InputError for more than 3,000 closed shapes, and, if
// nothing is closed, for the largest shape that nearly is; a drawing without shapes gets no parts.
void add_plain_parts(PlainDrawing plain, const std::string& file, Drawing& drawing);

}  // namespace selvedge::sim
