#pragma once
// Flat panels of trouser legs before and behind the legs that they close round.
#include <optional>

#include "sim/pattern/pattern.h"
#include "sim/place/limbs.h"

namespace selvedge::sim {

// The outermost point of a leg towards the middle of the body, which lies on its left (side < 0) or its right (> 0);
// none: 0, it is not known where.
std::optional<Vec2d> crotch_of(const Panel& leg, double side);

// Leans a placed panel about its crotch (panel frame, m), which stands in the middle of the body, so that its hem lies
// before or behind the leg: else it would close beside it. Pre: the leg was found.
void lean_to_leg(Panel& panel, const Vec2d& crotch, const Limb& leg);

}  // namespace selvedge::sim
