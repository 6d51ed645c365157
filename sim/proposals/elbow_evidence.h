#pragma once
// On which arm a sleeve goes: it bends forward at the elbow, so that the elbow is on its side to the back.
#include <vector>

#include "sim/proposals/chain_view.h"
#include "sim/proposals/open_boundary.h"
#include "sim/proposals/panel_facts.h"

namespace selvedge::sim {

// The odds that the cap belongs in the armhole, as the panels of the sleeve bend that meet both front and back; 0: they
// are straight, or meet only one of them. armhole and cap: the two sides of the seam.
double odds_of_elbow(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, const ChainView& armhole,
                     const ChainView& cap);

}  // namespace selvedge::sim
