#pragma once
// The thesis' own cloth, as a baseline for the solver of this program: a mass-spring network on the leaves of the
// adaptive mesh, with weak springs, bending elements, explicit Verlet integration and corrections of the lengths of
// edges. (thesis 3.6.2 to 3.6.6, listing 3.12; Provot 1995; Bridson, Marino and Fedkiw 2003)
//
// It works on the state of a sim::Cloth, so that the same mesh, criteria and colliders serve both. It uses no
// constraint of that cloth's solver.
#include "sim/cloth/cloth.h"
#include "sim/cloth/step.h"
#include "sim/core/gravity.h"
#include "sim/core/math.h"

namespace selvedge::sim {
class Collider;
}

namespace selvedge::bench {

struct ProvotOptions {
    int substeps = 4;                         // per step, each of Cloth::substep
    Vec3f gravity = sim::standard_gravity();  // m/s^2
    float spring = 0;                         // N/m, of each edge at every level (fig. 3.14); see stable_spring()
    float bending = 7.5e-6F;                  // N m
    float max_elongation = 0.1F;  // share of the rest length beyond which an edge is corrected (Provot: 10 %)
    int corrections = 1;          // iterations over all edges per sub-step
    float damping = 0.6F;         // 1/s
    float friction = 0.35F;       // Coulomb coefficient
    float offset = 0.003F;        // m, kept from the body at vertices
};

// Listing 3.12: shortens ab to `longest` (m) if it is longer. Each end moves in proportion to its inverse mass (1/kg,
// 0: pinned).
struct WeightedEnd {
    Vec3f x = Vec3f::Zero();  // m
    float inverse_mass = 0;
};
void correct_length(WeightedEnd& a, WeightedEnd& b, float longest);

// The largest spring constant (N/m) with which a square grid of `spacing` (m) is stable: dt^2 sum(2 k / m) < 4 at a
// corner, where a vertex has the mass of one triangle's third and three edges; times 0.8.
float stable_spring(float area_density, float spacing, float substep);

// One step: sub-steps of forces, integration, corrections, collisions. Adds to times->collision if given.
void provot_step(sim::Cloth& cloth, const sim::Collider& body, const ProvotOptions& options,
                 sim::StepTimes* times = nullptr);

// The forces of bending on a, b, left and right of a hinge, N, for positions of these (m); they sum to zero and turn
// nothing.
std::array<Vec3f, 4> bending_forces(const std::array<Vec3f, 4>& x, float bending);

}  // namespace selvedge::bench
