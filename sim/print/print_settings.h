#pragma once
// How a pattern is written for the cutting table: the choices of a person, for the command and the editor.
#include <string>
#include <string_view>
#include <vector>

namespace selvedge::sim {

struct PrintSettings {
    std::string paper = "a4";              // see parse_page_size()
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

// Without the choices that a kind of file has no use for and print_pattern() would refuse.
inline PrintSettings settings_for(PrintSettings settings, std::string_view extension) {
    const bool is_pdf = extension == ".pdf", is_dxf = extension == ".dxf";
    if (!is_pdf) settings.is_one_page = settings.is_on_fold = settings.prints_all = false;
    if (is_dxf) {
        settings.layers.clear();
        settings.is_layout = false;
    } else {
        settings.is_astm = false;
    }
    if (settings.is_layout) {
        settings.is_on_fold = false;
        if (is_pdf) settings.layers.clear();
    } else {
        settings.is_folded = settings.is_one_way = false;
    }
    return settings;
}

}  // namespace selvedge::sim
