#pragma once
// One time step of the cloth, divided into small sub-steps: Verlet prediction, one iteration over all constraints, then
// contacts. See docs/solver.md.  (thesis 3.6.4; Macklin et al. 2019, "Small Steps")
#include <functional>
#include <optional>
#include <span>

#include "sim/cloth/cloth.h"
#include "sim/cloth/contact_options.h"
#include "sim/core/gravity.h"
#include "sim/selfcontact/options.h"

namespace selvedge::sim {

class Collider;

// Two vertices of an open seam, which are pulled together until their distance is at most the allowed gap.
struct SeamPull {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    bool is_held = false;  // it is closed, whatever gap is allowed
};

// A kinematic vertex: it moves along a straight line in equal parts per sub-step and reaches its target at the end of
// the step.
struct KinematicVertex {
    std::uint32_t vertex = 0;  // a pinned vertex
    Vec3f to = Vec3f::Zero();  // target, m; outside of the body
};

// Wall-clock times of parts of a step, s. Each step adds its own.
struct StepTimes {
    double collision = 0;  // contact with the body, with the floor and of cloth with cloth
};

struct StepOptions {
    int substeps = 12;                    // each of length Cloth::substep
    Vec3f gravity = standard_gravity();   // m/s^2
    float extra_damping = 0;              // 1/s, in addition to the fabrics' damping
    float internal_damping = 40;          // 1/s, of the relative motion of the corners of a triangle
    float stretch_bias_rate = 3;          // 1/s, update rate of the biases of warp and weft, and of shear
    float shear_bias_rate = 1.2F;         // (solver_blocks.h). Higher rates are unstable, see docs/solver.md
    int limit_iterations = 2;             // extra iterations over triangles beyond the fabric's strain limit
    float max_move_per_substep = 0.005F;  // m, limit of displacement, so that vertices do not jump over thin parts
    ContactOptions contact{};
    std::optional<SelfContactOptions> self_contact{};  // none: cloth passes through itself
    std::span<const SeamPull> seams{};                 // open seams
    float seam_gap = 0;                                // m, allowed at the end of this step
    float seam_gap_rate = 0;                           // m per sub-step by which the gap shrinks within the step
    float floor_rate = 0;                              // m per sub-step by which the floor rises to contact.floor
    std::span<const KinematicVertex> kinematic{};
    // Optional: solves constraints of the caller in each sub-step, as the last of stretch. points: by vertex, x, y, z
    // (m) and the inverse mass (1/kg), then the dummy vertex; before: the same where the sub-step began. They are not
    // asked whether the cloth may rest. Simulation calls those of ClothConstraint (sim/simulation/cloth_constraint.h).
    std::function<void(float* points, const float* before)> solve_more{};
    bool may_rest = false;       // whether a cloth at rest is deactivated until something could move it (resting.h)
    StepTimes* times = nullptr;  // optional: the step is timed, and adds to it
};

struct StepReport {
    int substeps = 0;  // number of computed sub-steps: 0 if the cloth is at rest
};

// The simulated time of a step, s.
float step_seconds(const Cloth& cloth, const StepOptions& options);

// Pre: the contacts are those of the present leaves: adapt_cloth() or refresh_contacts() came after make_cloth().
StepReport step(Cloth& cloth, const Collider& body, const StepOptions& options);

}  // namespace selvedge::sim
