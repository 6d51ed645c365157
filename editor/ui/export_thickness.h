#pragma once
// How thick the cloth of an exported mesh is: named in a script, or chosen where the file is named.
#include <string>

#include "editor/ui/services.h"

namespace selvedge::editor {

struct AppState;

// "fabric", or a number of mm from 0.01 to 50. Throws InputError.
ExportThickness parse_export_thickness(const std::string& text);

// Controls for that of the next export (AppState::export_thickness).
void show_export_thickness(AppState& state);

}  // namespace selvedge::editor
