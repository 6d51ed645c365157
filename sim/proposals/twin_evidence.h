#pragma once
// What speaks for a seam between a panel and its mirror image: in the middle of the body, and nowhere else. Both sides
// are equal in length, shape and notches wherever they lie, so that these say nothing.
#include <vector>

#include "sim/proposals/chain_view.h"
#include "sim/proposals/open_boundary.h"
#include "sim/proposals/panel_facts.h"

namespace selvedge::sim {

// The logarithm of the odds that this line of the panel `own` is sewn to its mirror image on the panel `twin`; -100:
// never. points: of the chain, in the frame of `own`, m.
double odds_of_twins(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, int own, int twin,
                     const Chain& chain, const std::vector<Vec2d>& points);

}  // namespace selvedge::sim
