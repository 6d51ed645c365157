#pragma once
// What a panel is for, from its outline alone, drawn upright: trouser legs by their crotch, bodices by their armholes,
// sleeves by their cap. For patterns whose pieces have no names, or names that say nothing.
#include <vector>

#include "sim/pattern/pattern.h"
#include "sim/proposals/panel_role.h"

namespace selvedge::sim {

// Whether the outline goes up from an underarm, where it is widest, round an armhole to a shoulder and a neck.
bool looks_like_bodice(const Panel& panel);

// Whether the outline narrows from its widest place, where a crotch would be, both to the hem and to the waist, and
// much more on one side than on the other: the hook of a trouser leg.
bool looks_like_leg(const Panel& panel);

// Whether both sides stand out at one height, as the crotch of a leg without outer seam does; long sleeves do so too.
bool looks_like_whole_leg(const Panel& panel);

// The roles of all panels. The wider leg is the back; the bodice with the deeper neck, and the wider part of a skirt,
// is the front. Others are Unknown. told: what the garment's name says; only a name tells that a panel is of a skirt.
std::vector<PanelRole> roles_by_shape(const Pattern& pattern, GarmentPart told = GarmentPart::Unknown);

}  // namespace selvedge::sim
