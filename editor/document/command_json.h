#pragma once
// Commands as JSON, in scripts and journals: {"move_vertices": {"vertices": [{"panel": "front", "index": 2}], "by":
// [0.01, 0]}}. Fields that have their usual value may be left out, and are when written.
#include "editor/document/command.h"
#include "sim/core/json.h"

namespace selvedge {

Json to_json(const Command& command);

// Throws InputError naming the path: for a command or field that there is not, and for values of another kind, out of
// range or not finite.
Command parse_command(const JsonView& view);

}  // namespace selvedge
