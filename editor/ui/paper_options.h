#pragma once
// The rows above the name in the file browser that say how a drawing is imported and how a pattern is printed, and the
// same choices as words of a script.
#include <span>
#include <string>

#include "sim/paper/import_options.h"
#include "sim/print/print_settings.h"

namespace selvedge::editor {

struct AppState;

inline constexpr int kImportOptionRows = 2;
void show_import_options(AppState& state);

int print_option_rows(const std::string& ending);
void show_print_options(AppState& state, const std::string& ending);  // ".pdf", ".svg" or ".dxf"

// "unit cm size M allowance 10 measurements my.json". Throws InputError for other words.
sim::ImportOptions parse_import_options(std::span<const std::string> words);

// "paper a3 layers cut,sew width 140 one-page all on-fold layout folded one-way astm". Throws InputError.
sim::PrintSettings parse_print_options(std::span<const std::string> words);

}  // namespace selvedge::editor
