#pragma once
// Deactivation of a cloth at rest: its steps compute nothing until something could move it.
//
// The cloth is at rest when, for kRestSeconds, no vertex was farther than kRestReach from its position at the start of
// that time. Then its velocity is set to zero and the solver's state is kept. step() reactivates it if a vertex was
// moved, got a velocity (x_prev) or has another kinematic target, or if the body, gravity or contact options differ. It
// is also reactivated when its mesh, constraint blocks or contacts change: adaptation, pins, fabrics, a moved body.
//
// Only the whole cloth can rest, not parts of it: docs/solver.md says why.
#include <vector>

#include "sim/cloth/contact.h"
#include "sim/core/math.h"

namespace selvedge::sim {

struct Cloth;
struct StepOptions;
class Collider;

// m and s. A strip of 1.5 m swings with a period of 2 s. It stays within 1 mm for 0.5 s only if its amplitude is below
// 3.4 mm (kRestReach / (1 - cos 45 degrees)), so its speed below 11 mm/s: the speed at which a drape counts as settled.
inline constexpr float kRestReach = 1e-3F;
inline constexpr float kRestSeconds = 0.5F;

// m: a kinematic vertex with a target farther away than this reactivates the cloth.
inline constexpr float kKinematicReach = 1e-5F;

struct RestingState {
    std::vector<Vec4f> anchors;  // m, by vertex: the position when `still_seconds` was 0
    float still_seconds = 0;     // s without motion beyond kRestReach
    // The conditions of the last step.
    Vec3f gravity = Vec3f::Zero();
    ContactOptions contact{};
    const Collider* body = nullptr;
};

// Updates the state before a step. Returns true if the cloth is at rest, so that the step has nothing to compute. Sets
// the velocity of a cloth that has just come to rest to zero.
bool stays_at_rest(Cloth& cloth, const Collider& body, const StepOptions& options);

bool is_at_rest(const Cloth& cloth);

// Reactivates the cloth: the time without motion starts again from 0.
void reactivate(Cloth& cloth);

}  // namespace selvedge::sim
