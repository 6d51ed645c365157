#pragma once
// Where the panels of a hood start: its sides stand beside the head, and the strip between them is bent over it.
#include "sim/pattern/pattern.h"
#include "sim/place/limbs.h"

namespace selvedge::sim {

// way: 1 on the left of the body, -1 on its right. Pre: the head was found, with two joints or more.
void stand_beside_head(Panel& side, double way, const Limb& head);

// way: 1 if the lower edge of the strip belongs to the left side of the hood, -1 if to the right. Pre: the strip runs
// along x; the head was found, with two joints or more.
void bend_over_head(Panel& strip, double way, const Limb& head);

}  // namespace selvedge::sim
