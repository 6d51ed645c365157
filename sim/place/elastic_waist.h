#pragma once
// Trousers and skirts that are pulled on: their waist is closed all round and as wide as the hips, and an elastic or a
// string holds it, which a drawing does not show.
#include <vector>

#include "sim/pattern/pattern.h"
#include "sim/place/panel_flanks.h"
#include "sim/proposals/panel_role.h"

namespace selvedge::sim {

// What closes to a ring round the waist: both long edges of the waistband that trousers or a skirt hang from; without a
// waistband, the upper edges of trousers. Empty: there is none.
struct ClosedWaist {
    std::vector<SeamSide> edges;
    double length = 0;  // m, round the waist
};
ClosedWaist closed_waist(const Pattern& pattern, const std::vector<PanelRole>& roles, const SewnEdges& sewn);

// Gathers a closed waist that goes over the hips to a little less than the waist; girths of the body in m. Returns
// whether it does.
bool gather_waist(Pattern& pattern, const ClosedWaist& band, double waist, double hip);

}  // namespace selvedge::sim
