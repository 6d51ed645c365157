#pragma once
// Darts that a drawing has as lines inside of a part: two straight legs of one length from the outline to the tip,
// where the outline goes on across the dart's mouth. They are cut into the outline, so that both legs are edges, which
// seams can join; otherwise the side with the dart would be longer than the one it is sewn to.
//
//      |            |
//      |\            \.
//      | >     ->     >
//      |/            /
//      |            |
#include <cstddef>
#include <vector>

#include "sim/paper/drawing.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

struct DrawnDarts {
    int count = 0;
    std::vector<std::size_t> lines = {};  // indices of those that are legs
};

// Cuts the darts of these lines, m, into the outline. Edges keep what they have; a leg has what the edge at its mouth
// has. Pre: the outline is closed, counter-clockwise, and has no notches yet.
DrawnDarts cut_drawn_darts(Panel& outline, const std::vector<DrawnPath>& lines);

}  // namespace selvedge::sim
