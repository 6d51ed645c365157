#pragma once
// Moving the cloth on by one step of small sub-steps: Verlet prediction, then each constraint once, then contacts.
// (SPEC 2; Macklin et al. 2019)
#include <span>

#include "sim/cloth/cloth.h"
#include "sim/cloth/contact.h"

namespace selvedge::sim {

class Collider;

// Two vertices that are pulled together until they are no further apart than the allowed gap: an open seam.
struct SeamPull {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
};

// A vertex that does not move by itself but is led: evenly, until at the end of a step it is there.
struct KinematicVertex {
    std::uint32_t vertex = 0;  // pinned
    Vec3f to = Vec3f::Zero();  // m, outside of the body
};

struct StepOptions {
    int substeps = 12;                    // each of Cloth::substep
    Vec3f gravity = Vec3f(0, -9.81F, 0);  // m/s^2
    float extra_damping = 0;              // 1/s, on top of the fabrics'
    float internal_damping = 40;          // 1/s, of the motion of neighbouring vertices against each other
    float stretch_bias_rate = 3;          // 1/s, how fast biases follow (solver_blocks.h): slower than what the cloth
    float shear_bias_rate = 1.2F;         // does by itself, or they feed its motion
    int limit_rounds = 2;                 // more passes over what one leaves beyond the strain limit
    float max_move_per_substep = 0.005F;  // m: contacts see thin parts at this speed
    ContactOptions contact{};
    std::span<const SeamPull> seams{};  // open seams
    float seam_gap = 0;                 // m, allowed at the end of this step
    float seam_gap_rate = 0;            // m per sub-step by which the gap shrinks within the step
    std::span<const KinematicVertex> led{};
    bool may_rest = false;  // a cloth that has come to rest is left as it is until something could move it (resting.h)
};

struct StepReport {
    int substeps = 0;  // that were computed: none if the cloth rests
};

// s, simulated.
float step_seconds(const Cloth& cloth, const StepOptions& options);

StepReport step(Cloth& cloth, const Collider& body, const StepOptions& options);

}  // namespace selvedge::sim
