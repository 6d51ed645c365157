#pragma once
// Opening and saving fabric files, and the questions before values that were edited would be lost.
#include <functional>
#include <string>

namespace selvedge::editor {

struct AppState;

void open_fabric(AppState& state, const std::string& file);  // its values are then shown

// Writes the draft of the fabric to its own file, which the garment then takes. Asks first if the file holds something
// else than what was read of it. False: not saved (yet).
bool save_fabric(AppState& state, const std::string& name);

// Writes the draft of the fabric to another file, and makes of it what the document makes of `name`. Asks first if
// there is a file.
void save_fabric_as(AppState& state, const std::string& name, const std::string& file);

// Opens the file browser for it.
void browse_to_open_fabric(AppState& state);
void browse_to_save_fabric(AppState& state, const std::string& name);
void browse_for_fabric_picture(AppState& state, const std::string& name);  // that its draft shows

// Runs `go_on` when no draft has changes any more. Asks about each that has.
void after_asking_about_fabrics(AppState& state, std::function<void(AppState&)> go_on);

}  // namespace selvedge::editor
