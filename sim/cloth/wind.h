#pragma once
// Wind and the drag of still air.  (SPEC 2)
//
// Per triangle: across the cloth the dynamic pressure of the air that comes towards it, 1/2 rho c v|v|; in all
// directions the fabric's air drag, in proportion to speed. Both are followed exactly over the time that is asked for
// (v' = v / (1 + k |v| t), v' = v exp(-k t)), so the lightest fabric in a storm is only carried along.
#include "sim/core/math.h"

namespace selvedge::sim {

struct Cloth;

struct Wind {
    Vec3f velocity = Vec3f::Zero();  // m/s; zero: still air
    float density = 1.2F;            // kg/m^3
    float coefficient = 1.2F;        // of the pressure on a plate across the wind
};

// Gives the cloth the speed that `seconds` of wind do: before the steps that take that long.
void blow(Cloth& cloth, const Wind& wind, float seconds);

}  // namespace selvedge::sim
