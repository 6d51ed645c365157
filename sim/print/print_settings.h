#pragma once
// How a pattern is written for the cutting table: the choices of a person, for the command and the editor.
#include <string>
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

}  // namespace selvedge::sim
