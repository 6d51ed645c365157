#pragma once
// Applies SetFields (part_commands.h) to a pattern.
#include "editor/document/part_commands.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// Throws GeometryError if there is no such part or field, or if a value is out of its range.
void set_fields(sim::Pattern& pattern, const SetFields& command);

}  // namespace selvedge::editor
