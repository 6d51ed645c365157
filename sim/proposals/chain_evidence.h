#pragma once
// What speaks for and against a seam between two chains of unsewn edges, as logarithms of odds.
// (The weights were set by hand on shipped garments and on published GarmentCode patterns, whose seams are known.)
#include <vector>

#include "sim/proposals/chain_fit.h"
#include "sim/proposals/chain_view.h"
#include "sim/proposals/open_boundary.h"
#include "sim/proposals/panel_facts.h"

namespace selvedge::sim {

// second is reversed: its end is sewn to the start of first.
Evidence weigh(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, const ChainView& first,
               const ChainView& second);

}  // namespace selvedge::sim
