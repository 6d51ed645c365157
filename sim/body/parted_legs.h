#pragma once
// Thighs of a body from a file that touch, or cut each other, have no place between them for cloth: trousers would pass
// through the body at the crotch. Flesh gives way there: both go back to either side of the middle between them, until
// the room that two layers of cloth need opens below the crotch, as it does on a mannequin.
//
//        \    crotch    /              \    crotch    /        left ||right thigh  ->  left |  | right
//         \     /\     /                \     /\     /
//          |    ||    |        ->        |   /  \   |          Only the inner sides move, those that are nearest to
//          |    ||    |                  |   |  |   |          the middle by most; their order stays.
#include <optional>

#include "sim/body/body.h"

namespace selvedge::sim {

// m, between two sides of flesh: a sleeve and the side of a shirt, or the legs of trousers, with their contact offsets.
inline constexpr double kRoomForCloth = 0.008;

// The height at which the legs join, m: of the lowest vertex from which the surface leads down to the floor on both
// sides of it. None if there are no two legs, or they join at the knees or below.
std::optional<double> crotch_of(const Body& body);

// Moves x. Returns by how much thighs have moved at most, m; 0 where there was room, or no legs were found. Pre: the
// body stands on the floor; where it has a skin, that is bound at x.
double part_legs(Body& body);

}  // namespace selvedge::sim
