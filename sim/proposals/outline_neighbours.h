#pragma once
// What lies beside a stretch of an outline in its panel, as evidence for seams: what kind of edge it is follows from
// its neighbours.
#include <vector>

#include "sim/proposals/chain_view.h"
#include "sim/proposals/open_boundary.h"
#include "sim/proposals/panel_facts.h"

namespace selvedge::sim {

// Whether neither neighbour in its panel is curved, as the hem of a sleeve lies between its two straight seams.
bool is_sleeve_hem(const OpenBoundary& boundary, const ChainView& view);

// Whether a front and a back would be closed up to their shoulders, as the sides of a tabard, which leaves no way for
// an arm: above both sides lie equal straight stretches that look up, each on its side of the body.
bool leaves_no_armhole(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, const ChainView& a,
                       const ChainView& b);

}  // namespace selvedge::sim
