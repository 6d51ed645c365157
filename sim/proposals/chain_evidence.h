#pragma once
// What speaks for and against a seam between two chains of unsewn edges, as logarithms of odds.
// (The weights were set by hand on shipped garments and on published GarmentCode patterns, whose seams are known.)
#include <string>
#include <vector>

#include "sim/proposals/open_boundary.h"
#include "sim/proposals/panel_role.h"

namespace selvedge::sim {

// A chain, or a part of one, as it would be sewn.
struct ChainView {
    Chain chain;
    int first = 0;            // of a loop: the atom in chain.atoms at which the seam begins
    double from = 0, to = 1;  // the part that is sewn, as fractions of the chain's length from `first` on
};

// What the evidence needs to know of the panels.
struct PanelFacts {
    PanelRole role;
    double axis = 0;               // x of the panel's middle, m
    double width = 0, height = 0;  // m
    bool is_symmetric = false;     // its right half mirrors its left one
    int twin = -1;                 // the panel that is its mirror image; -1: none
    bool has_other_face = false;   // another panel is the back of this front, or the front of this back
    bool has_opening = false;      // the garment is closed by buttons or a zip
};

struct Evidence {
    double odds = 0;  // natural logarithm
    std::string reason;
    bool is_possible = true;  // false: whatever the odds are, it is no seam
};

// second is reversed: its end is sewn to the start of first.
Evidence weigh(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, const ChainView& first,
               const ChainView& second);

std::vector<PanelFacts> facts_of(const Pattern& pattern, std::string_view hints);

// The length of the part that is sewn, m.
double length_of(const ChainView& view);

// The atom and its fraction at the fraction t of a view.
struct ChainPlace {
    int atom = 0;
    double t = 0;
};
ChainPlace place_on(const OpenBoundary& boundary, const ChainView& view, double t);

// The fractions of a view at which its atoms begin and end, without 0 and 1, ascending.
std::vector<double> joints_of(const OpenBoundary& boundary, const ChainView& view);

}  // namespace selvedge::sim
