#pragma once
// What is special in each phase of a garment's way: while its seams close, while it falls, while its body moves. What
// is common to all of them is in SimulationOptions (sim/simulation/simulation.h).
#include <limits>
#include <span>

#include "sim/cloth/step.h"

namespace selvedge::sim {

class Collider;

// m, contact offset of sewn cloth where it touches the body. The offset of cloth that is sewn, 3 mm, would add 1.9 cm
// to every girth.
inline constexpr float kRestOffset = 0.0003F;

struct Schedule {
    // Of its steps.
    float gravity = 1;                                        // share of it
    float damping = 0;                                        // 1/s, in addition to the fabrics'
    float friction = 1;                                       // share of the friction with the body
    float bias_rate = 1;                                      // share of the usual rates of the solver's biases
    float thickness = 1;                                      // share of the cloth's, where it meets itself
    int substeps = StepOptions{}.substeps;                    // per step
    int limit_iterations = StepOptions{}.limit_iterations;    // over triangles beyond the fabric's strain limit
    float longest_move = StepOptions{}.max_move_per_substep;  // m, of a vertex in a sub-step
    bool meets_itself = true;                                 // where the options say so
    bool may_rest = false;                                    // steps skip a cloth at rest (sim/cloth/resting.h)

    // Where it meets the body and the floor.
    const Collider* held_by = nullptr;  // the body that holds the cloth, for constraints; null: that of the step
    float offset = std::numeric_limits<float>::infinity();          // m, where it is less than the usual one
    float sample_spacing = std::numeric_limits<float>::infinity();  // m, the same
    float lowered_floor = 0;                                        // m, by which the floor is lower after a step
    float floor_rise = 0;                                           // m, by which it rises within the step

    // What leads it.
    std::span<const SeamPull> seams{};             // open seams
    float seam_gap = 0;                            // m, allowed at the end of a step
    float seam_gap_rate = 0;                       // m per sub-step by which it shrinks
    std::span<const KinematicVertex> kinematic{};  // where no one leads vertices (Simulation::lead)

    // Of its adaptations.
    bool may_split = true;
    bool may_rejoin = true;
};

// Panels that are not sewn: weightless, without friction, while their seams close or are held closed.
Schedule closing_seams(std::span<const SeamPull> seams);

// The same, under that share of gravity, with friction: what is sewn last falls before its limbs move.
Schedule falling_unsewn(std::span<const SeamPull> seams, float weight);

// Sewn cloth without gravity and friction: the tension of the seams relaxes, and what crumpled slides flat.
Schedule relaxing();

// Sewn cloth under that share of gravity, against air drag.
Schedule falling(float weight);

// At the end of a fall: in finer sub-steps, as many as that, residual stretch is removed.
Schedule finishing(int substeps);

// At rest on the body, as a drape left it.
Schedule hanging();

// On a body that moves.
Schedule moving(float air_damping);

// Refined where it hangs, after a change of the pattern.
Schedule carried_over();

}  // namespace selvedge::sim
