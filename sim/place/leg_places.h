#pragma once
// Where the panels of trousers start: flat ones before and behind the legs, tubes and cuffs round them.
#include <optional>
#include <span>

#include "sim/pattern/pattern.h"
#include "sim/place/limbs.h"
#include "sim/place/placement.h"

namespace selvedge::sim {

// The outermost point of a leg towards the middle of the body, which lies on its left (side < 0) or its right (> 0);
// none: 0, it is not known where.
std::optional<Vec2d> crotch_of(const Panel& leg, double side);

// Leans a placed panel about its crotch (panel frame, m), which stands in the middle of the body, so that its hem lies
// before or behind the leg: else it would close beside it. Pre: the leg was found.
void lean_to_leg(Panel& panel, const Vec2d& crotch, const Limb& leg);

// A panel that goes all round a leg, from the outside between the legs to the outside, as of trousers that wrap: the
// crotch is a notch in the middle of its upper edge.
struct LegTube {
    Vec2d crotch = Vec2d::Zero();  // its lowest place, panel frame, m
    bool is_of_left = false;       // by the back, whose part of the crotch is the wider one
};
// crotch_edges: those that are sewn to the other leg. None: the panel is no such tube.
std::optional<LegTube> leg_tube(const Panel& panel, std::span<const int> crotch_edges);

// Where its middle lies between the legs, its crotch at that height, m. None: it is too narrow to stand round the leg.
// Pre: the leg was found.
std::optional<ArrangementPoint> place_of_tube(const Panel& panel, const LegTube& tube, const Limb& leg, double crotch);

// Where a cuff that is sewn to a hem there (m) goes round the ankle: below the hem, but clear of the foot, which it
// cannot close round. Pre: the leg was found.
ArrangementPoint place_of_leg_cuff(const Panel& cuff, const Vec3d& hem, const Limb& leg);

}  // namespace selvedge::sim
