#pragma once
// Trousers and skirts that are pulled on: their waist is closed all round and as wide as the hips, and an elastic or a
// string holds it, which a drawing does not show.
#include <vector>

#include "sim/pattern/pattern.h"
#include "sim/place/panel_flanks.h"
#include "sim/proposals/panel_role.h"

namespace selvedge::sim {

// Both long edges of the waistband that closes to a ring and that trousers or a skirt hang from. Empty: there is none.
std::vector<SeamSide> closed_waistband(const Pattern& pattern, const std::vector<PanelRole>& roles,
                                       const SewnEdges& sewn);

// Gathers a closed waistband that goes over the hips to a little less than the waist; girths of the body in m. Returns
// whether it does.
bool gather_waistband(Pattern& pattern, const std::vector<SeamSide>& band, double waist, double hip);

}  // namespace selvedge::sim
