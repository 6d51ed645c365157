#pragma once
// Makes a pattern of a drawing: each part's sewing line becomes the outline of a panel, in metres; seam allowances are
// taken off, halves that are cut on the fold are unfolded, mirrored pairs get their second panel, notches, grain, fold
// lines and drill points come along. Placement and seams that the drawing does not state come later
// (sim/pattern/seam_proposals.h, sim/place).
#include <optional>
#include <string>
#include <vector>

#include "sim/paper/drawing.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

struct MakePanelsOptions {
    std::optional<double> metres_per_unit = {};  // wins over the file; none: the file's, or a guess from the size
    std::optional<double> allowance = {};        // m, of outlines that include it; none: the file's, or none
    std::string size = {};                       // of a file with several; empty: the middle one
};

struct PanelsOfDrawing {
    Pattern pattern;                 // side by side on the sheet; in space at the origin, or as the drawing says
    std::vector<std::string> notes;  // what was guessed, repaired or left out, one line each
    std::vector<std::string> sizes;  // that the file has, in its order
    bool is_unit_guessed = false;
    bool is_placed = false;                 // the drawing states body and placements, which the pattern has
    std::string hints;                      // texts about the whole garment, for roles_of()
    std::vector<std::string> ribbing = {};  // names of drawn panels that are cut from it (fold_ribbing)
};

// Throws InputError if no part has a closed outline and the drawing has no pictures, if the size is not in the file, or
// if an outline crosses itself; `file` is the name in messages.
PanelsOfDrawing make_panels(const Drawing& drawing, const std::string& file, const MakePanelsOptions& options = {});

}  // namespace selvedge::sim
