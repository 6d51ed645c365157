#pragma once
// How hard a garment at rest presses on its body. The solver keeps no force of a contact: in each sub-step it moves
// what would enter the body out of it, after all other constraints. The force of the body on a vertex is the mass of
// the vertex times this motion, divided by the square of the sub-step. Here it is measured: the cloth goes on for some
// time, and once in each step one sub-step is computed twice from the same state, with the body and without it. The
// difference is the motion that the body caused, with its friction. At rest, the sum of these forces is the weight of
// the garment.
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

class Collider;
class Simulation;

struct ContactPressureOptions {
    int settling_steps = 12;  // of 1/120 s, before it is measured
    int measured_steps = 60;  // of 1/120 s: the forces are the mean over these
};

// Per leaf vertex, in the order of draw_mesh().
struct ContactPressure {
    std::vector<Vec3f> force;     // N, of the body on the vertex, with friction
    std::vector<float> pressure;  // N/m^2: the part of the force along the body's normal, per area of cloth, >= 0
};

// The floor's forces are left out, and what cloth presses on cloth counts only where it reaches the body.
// Pre: the cloth's positions are finite, and it was draped on this body.
ContactPressure measure_contact_pressure(Simulation simulation, const Collider& body,
                                         const ContactPressureOptions& measuring = {});

}  // namespace selvedge::sim
