#pragma once
// The inner loops of a sub-step, one set for each kind of vector instructions; for their bits see simd_level.h.
//
// Points are four floats: x, y, z in metres and, fourth, the inverse mass (1/kg), 0 for what cannot move.
#include <cstddef>
#include <cstdint>
#include <span>

#include "sim/cloth/contact.h"
#include "sim/cloth/solver_blocks.h"
#include "sim/collide/collider.h"
#include "sim/core/simd_level.h"

namespace selvedge::sim {

struct Motion {
    float keep = 1;               // share of the last move that goes on
    std::array<float, 3> fall{};  // m, that every sub-step adds: acceleration times h^2
};

// Of vertices, four floats each.
struct CorrectedPoints {
    float* points = nullptr;
    float* predicted = nullptr;   // before stretch and shear corrected them
    float* start = nullptr;       // the same with the momentum of corrections
    float* correction = nullptr;  // what stretch and shear moved them by
};

struct BiasGains {
    float stretch = 0;  // share of the error that is added to the bias of warp and weft
    float shear = 0;
    float least = -0.02F;  // of warp and weft: cloth that is held compressed must not learn to be longer
    float most = 0.3F;
};

// The arrays of RestrictedStress. below, off: all zero before the biases are moved, and after.
struct StressSums {
    const float* above = nullptr;
    float* below = nullptr;
    float* off = nullptr;
};

struct ContactLimits {
    float longest_move = 0;  // m per sub-step
    float floor = 0;         // m: height of the floor's offset surface
    float offset = 0;        // m, kept from the body
    float margin = 0;        // m, by which a collider's distance may be too large
    float friction_scale = 1;
};

// Of sixteen samples: whether one must ask the collider, and whether one touches as far as is known.
struct SampleState {
    bool asks, touches;
};

struct Kernels {
    // Gains of constraints from the inverse masses of their vertices (1/kg; 0: cannot move), after an adaptation.
    void (*update_stretch_masses)(std::span<StretchBlock> blocks, std::span<const StretchRecord> records,
                                  const float* inverse_masses);
    void (*update_bend_masses)(std::span<BendBlock> blocks, std::span<BendRecord> records, const float* inverse_masses);

    // The same of refined triangles. masses: of a vertex with all that follows it, kg; 0: cannot move.
    void (*update_coarse_bend_masses)(std::span<CoarseBendBlock> blocks, std::span<BendRecord> records,
                                      const float* masses);

    // What refined triangles move their corners by. masses: of a corner with all that follows it, kg; 0: cannot move.
    void (*update_limit_masses)(std::span<LimitBlock> blocks, std::span<LimitRecord> records, const float* masses);

    // Verlet: before := points, points += keep (points - before) + fall. What rounding takes from a move goes into
    // `lost` and is added to the next one: a move is a few steps of a float long, so that a hundredth of gravity would
    // be lost.
    void (*predict)(float* points, float* before, float* lost, std::size_t count, const Motion& motion);

    // predicted := points, points += momentum correction, start := points; and correction := points - predicted.
    void (*add_momentum)(const CorrectedPoints& corrected, std::size_t count, float momentum);
    void (*keep_corrections)(const CorrectedPoints& corrected, std::size_t count);

    // One pass over warp, weft and shear; anchors of friction follow. With `records` the multipliers are kept. Lanes in
    // which warp or weft was beyond the fabric's strain limit are copied into `over`, which has room for as many
    // blocks; returns into how many. Pre: all blocks are of one colour. spare: of spare lanes.
    std::size_t (*solve_stretch)(std::span<StretchBlock> blocks, StretchRecord* records, float* points, OverBlock* over,
                                 const OverBlock& spare);

    // Takes back what warp and weft are beyond the fabric's strain limit.
    void (*limit_stretch)(std::span<const OverBlock> blocks, float* points);

    // One pass over the bending of triangles; anchors of friction follow. Of refined ones, of those alone to which
    // something was handed up. interval: of those that are visited as often as that or more often.
    void (*solve_bend)(std::span<BendBlock> blocks, float* points, int interval);
    void (*solve_coarse_bend)(std::span<CoarseBendBlock> blocks, float* points, int interval);

    // Takes back what warp and weft of refined triangles are longer than they may be, with the shear that goes with it;
    // with `records` the multipliers are kept.
    void (*limit_parents)(std::span<const LimitBlock> blocks, LimitRecord* records, float* points);

    // Moves the centres by half of what the ends of their edges moved since `before`.
    void (*restrict_centres)(std::span<const EdgeCentre> centres, const float* before, float* points);

    // What a level of refined triangles and all that each is inside of carry, by the last multipliers. Levels go coarse
    // to fine. above: of RestrictedStress.
    void (*restrict_stress)(std::span<const LimitRecord> records, float* above);

    // Moves each bias towards the one with which strain and stress agree with the fabric, whoever carries the stress:
    // of leaves by what each is off by; of refined triangles, in warp and weft, by what the leaves in them are off by
    // on an average, while their shear goes by their share of the tension. First the leaves, then the refined
    // triangles, fine to coarse.
    void (*update_bias)(std::span<StretchBlock> blocks, std::span<const StretchRecord> records, const float* points,
                        const float* before, const BiasGains& gains, const StressSums& sums);
    void (*update_parents)(std::span<LimitBlock> blocks, std::span<LimitRecord> records, const BiasGains& gains,
                           const StressSums& sums);

    // Threads rub against each other: corners lose a share of what they moved against one another since `before`, the
    // cloth as a whole nothing.
    void (*rub)(std::span<const StretchBlock> blocks, const float* points, float* before, float share);

    // Shortens what moved too far since `before`, and puts what touches the body, as far as is known, or is below the
    // floor onto its offset surface; friction takes tangential motion since `before` off, by up to its coefficient
    // times the depth. The offsets of the movable points that must ask the collider go into `found`; returns how many.
    // Pre: begin and end, of points, are multiples of sixteen; found has room for all.
    std::size_t (*hold_moves)(float* points, const float* before, const ContactKnowledge& known, const float* friction,
                              std::size_t begin, std::size_t end, const ContactLimits& limits, std::uint32_t* found);

    // The same for sixteen points that have asked; notes what they now know.
    void (*answer_vertices)(const ContactBlock& said, const std::uint32_t* offsets, const float* friction,
                            const ContactLimits& limits, const float* before, float* points,
                            const ContactKnowledge& known);

    // Where the samples are, ready to ask; notes what they now know when they have; and puts those that touch out.
    SampleState (*look_at_samples)(const SampleBlock& block, const float* points, ContactBlock& at_points);
    void (*answer_samples)(const ContactBlock& said, const ContactLimits& limits, SampleBlock& block);
    void (*push_samples)(SampleBlock& block, const ContactLimits& limits, float* points, float* before);
};

const Kernels& kernels(SimdLevel level);

// Those of one level; each is defined by the compilation of kernels_simd.cpp for that level.
template <SimdLevel>
const Kernels& kernels_of();

// The floats of points, as the loops take them. Pre: there is one.
template <class Point>
float* floats(std::vector<Point>& points) {
    return points.front().data();
}

}  // namespace selvedge::sim
