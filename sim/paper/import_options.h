#pragma once
// How drawings of other programs become a garment: the choices of a person, for the command and the editor.
#include <filesystem>
#include <string>

#include "sim/paper/make_panels.h"

namespace selvedge::sim {

struct ImportOptions {
    MakePanelsOptions panels;
    double least_confidence = 0.5;            // of the seams that are sewn
    std::string body = {};                    // round which the panels are placed; empty: of the measurements
    std::filesystem::path measurements = {};  // file; empty: those of the drawing; the female mannequin if it has none
};

}  // namespace selvedge::sim
