#pragma once
// A cloth that has come to rest is left out of the steps, whole, until something could move it.
//
// It rests when for kRestSeconds none of its vertices was farther than kRestReach from where it stood when this time
// began. Then it has no speed, and all that the solver has learnt stays as it is. Whoever steps it wakes it by what is
// different: a vertex that was moved, pushed (x_prev) or is led elsewhere; another body, gravity or contact options. It
// is also woken when its mesh, its blocks or its contacts change: adaptation, pins, fabrics, a body that has moved.
//
// Parts of it do not rest by themselves: docs/solver.md says why.
#include <vector>

#include "sim/cloth/contact.h"
#include "sim/core/math.h"

namespace selvedge::sim {

struct Cloth;
struct StepOptions;
class Collider;

// m and s. What swings to and fro in 2 s, as a strip of 1.5 m does, stays within the reach for so long only if it
// swings by less than 3.4 mm (reach / (1 - cos 45 degrees)), so at 11 mm/s at most: the speed at which a drape counts
// as settled.
inline constexpr float kRestReach = 1e-3F;
inline constexpr float kRestSeconds = 0.5F;

// m: a led vertex that is to go farther wakes the cloth. A hand goes a tenth of its way with each step.
inline constexpr float kKinematicReach = 1e-5F;

struct RestingState {
    std::vector<Vec4f> anchors;  // m, by vertex: where it stood when the quiet time began
    float quiet = 0;             // s since then
    // What the last step went by.
    Vec3f gravity = Vec3f::Zero();
    ContactOptions contact{};
    const Collider* body = nullptr;
};

// Looks at what the next step would begin with. Returns whether the cloth rests, so that there is nothing to do; a
// cloth that has just come to rest loses what speed it had.
bool stays_at_rest(Cloth& cloth, const Collider& body, const StepOptions& options);

bool is_at_rest(const Cloth& cloth);

// It begins to be quiet anew.
void wake(Cloth& cloth);

}  // namespace selvedge::sim
