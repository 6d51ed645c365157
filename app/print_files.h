#pragma once
// Writes patterns for the cutting table, as pages, drawings or cutting layouts: for the command and the editor.
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/pattern/pattern.h"
#include "sim/print/print_settings.h"

namespace selvedge::app {

using sim::PrintSettings;

struct Printed {
    std::string what;                // "20 pages, 7 across and 3 down, and a cover"
    std::vector<std::string> notes;  // what the cutter has to know, one line each
};

inline constexpr std::array<std::string_view, 3> kPrintFormats{".pdf", ".svg", ".dxf"};

// Replaces the file; its extension selects the format. Throws InputError.
Printed print_pattern(const sim::Pattern& pattern, const std::filesystem::path& file, const PrintSettings& settings);

// The sheet of print_pattern()'s SVG, with all layers. Throws InputError.
std::string svg_of_pattern(const sim::Pattern& pattern);

}  // namespace selvedge::app
