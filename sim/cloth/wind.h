#pragma once
// Wind, and the drag of still air.
//
// Per triangle: normal to the cloth the dynamic pressure of the relative wind, 1/2 rho c v|v|; in all directions the
// fabric's air drag, proportional to the relative speed. Both are integrated analytically over the given time
// (v' = v / (1 + k |v| t), v' = v exp(-k t)), so even the lightest fabric never exceeds the speed of the wind.
#include "sim/core/math.h"

namespace selvedge::sim {

struct Cloth;

struct Wind {
    Vec3f velocity = Vec3f::Zero();  // m/s; zero: still air
    float density = 1.2F;            // kg/m^3
    float coefficient = 1.2F;        // drag coefficient of a plate normal to the wind
};

// Adds the velocity that the wind causes in `seconds`. Call it before the steps that simulate this time.
void blow(Cloth& cloth, const Wind& wind, float seconds);

}  // namespace selvedge::sim
