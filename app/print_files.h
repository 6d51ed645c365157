#pragma once
// Writes patterns for the cutting table, as pages, drawings or cutting layouts: for the command and the editor.
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::app {

struct PrintSettings {
    std::string paper = "a4";              // see sim::parse_page_size()
    std::vector<std::string> layers = {};  // names; empty: all
    double fabric_width = 1.5;             // m, of a cutting layout
    bool is_one_page = false;
    bool prints_all = false;  // also mirror images, in a PDF
    bool is_on_fold = false;  // halves of symmetric panels, in a PDF
    bool is_layout = false;
    bool is_one_way = false;
    bool is_folded = false;
    bool is_astm = false;
};

struct Printed {
    std::string what;                // "20 pages, 7 across and 3 down, and a cover"
    std::vector<std::string> notes;  // what the cutter has to know, one line each
};

inline constexpr std::array<std::string_view, 3> kPrintFormats{".pdf", ".svg", ".dxf"};

// Replaces the file; its extension selects the format. Throws InputError.
Printed print_pattern(const sim::Pattern& pattern, const std::filesystem::path& file, const PrintSettings& settings);

}  // namespace selvedge::app
