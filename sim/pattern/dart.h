#pragma once
// Darts that open at a panel's outline: two legs that are sewn to each other and meet inside, at the dart's tip.
#include <span>
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// The edges at a dart's mouth, in the order of the outline.
enum class DartSide { Before, After };

struct Dart {
    int first_leg = 0;  // index of the first edge after the mouth begins
    int leg_edges = 1;  // the legs are the edges first_leg to first_leg + 2 * leg_edges - 1, modulo the panel's number
    DartSide pressed_to = DartSide::Before;  // when it is sewn, its folded cloth lies under this side
    bool is_level = false;                   // it lies across the body, as a bust dart from the side seam

    bool operator==(const Dart&) const = default;
};

// Of the panel with this index in the seams. A level dart is pressed down, an upright one to the centre of the body
// (Armstrong 2014, "Patternmaking for Fashion Design"), as the panel is placed round the body.
std::vector<Dart> find_darts(const Panel& panel, int index, std::span<const Seam> seams);

}  // namespace selvedge::sim
