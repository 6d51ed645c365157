#pragma once
// What speaks for and against a seam between two chains of unsewn edges, as logarithms of odds.
// (The weights were set by hand on shipped garments and on published GarmentCode patterns, whose seams are known.)
#include <string>
#include <vector>

#include "sim/proposals/chain_view.h"
#include "sim/proposals/open_boundary.h"
#include "sim/proposals/panel_facts.h"

namespace selvedge::sim {

struct Evidence {
    double odds = 0;  // natural logarithm
    std::string reason;
    bool is_dart = false;     // both sides are the legs of a dart
    bool is_possible = true;  // false: whatever the odds are, it is no seam
};

// second is reversed: its end is sewn to the start of first.
Evidence weigh(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, const ChainView& first,
               const ChainView& second);

}  // namespace selvedge::sim
