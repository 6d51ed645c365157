#pragma once
// Closed shapes of a plain drawing that are no part of a pattern: page frames, test squares, letters and logos, legends
// and scale bars.
#include <optional>
#include <string>
#include <vector>

#include "sim/paper/plain_areas.h"

namespace selvedge::sim {

struct NotPanels {
    std::vector<std::string> notes = {};         // what was left out, one line each
    std::optional<double> metres_per_unit = {};  // that a labelled test square proves; none: there is none
};

// Marks areas as left out; what lies in a page frame moves up to the area around the frame.
NotPanels leave_out_what_is_no_panel(const PlainDrawing& drawing, std::vector<PlainArea>& areas);

// The lengths that a text names, m: "5 cm", "2 in / 50.8 mm", "1\"". A number without a unit is none.
std::vector<double> lengths_in(std::string_view text);

}  // namespace selvedge::sim
