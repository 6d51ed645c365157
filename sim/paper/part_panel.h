#pragma once
// Makes a panel of one part of a drawing: its sewing line becomes the outline, in metres; seam allowances are taken
// off, darts cut out, a half on the fold is unfolded; notches, grain, lines and drill points come along.
#include <optional>
#include <string>
#include <vector>

#include "sim/paper/drawing.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

struct PartPanel {
    std::optional<Panel> panel;      // none: the part has no closed outline
    std::vector<std::string> notes;  // what was guessed, repaired or left out, one line each
    bool is_placed = false;          // as the part says
    bool is_unfolded = false;        // a half on the fold was made whole
    bool is_mirrored = false;        // the sewing line runs clockwise: its edges are in the opposite order
};

// scale: m per unit of the drawing. allowance: m, of outlines that include it; none: no such. Throws InputError with
// `file` if the outline crosses itself.
PartPanel panel_of_part(const DrawnPart& part, const Drawing& drawing, double scale,
                        const std::optional<double>& allowance, const std::string& file);

}  // namespace selvedge::sim
