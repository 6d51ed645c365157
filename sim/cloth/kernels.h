#pragma once
// The inner loops of a sub-step, one set for each kind of vector instructions, all with the same bits.
//
// Points are four floats: x, y, z in metres and, fourth, the inverse mass (1/kg), 0 for what cannot move.
#include <cstddef>
#include <cstdint>
#include <span>

#include "sim/cloth/solver_blocks.h"
#include "sim/core/simd_level.h"

namespace selvedge {

struct Motion {
    float keep = 1;               // share of the last move that goes on
    std::array<float, 3> fall{};  // m, that every sub-step adds: acceleration times h^2
};

struct MoveLimits {
    float longest_move;  // m per sub-step
    float floor;         // m: what is lower asks, whatever it knows of the body
};

struct BiasGains {
    float stretch = 0;  // share of the error that is added to the bias of warp and weft
    float shear = 0;
    float least = -0.02F;  // of warp and weft: cloth that is held compressed must not learn to be longer
    float most = 0.3F;
};

// What a collider said of sixteen points, and what is made of it.
struct ContactReply {
    const float *x, *y, *z;  // asked, m
    const float* distance;
    const float *nx, *ny, *nz;
    float offset;  // m, kept from the body
    float margin;  // m, by which a distance may be too large
    float friction_scale;
};

struct Kernels {
    // Gains of constraints from the inverse masses of their vertices (1/kg; 0: cannot move), after an adaption.
    void (*weigh_stretch)(std::span<StretchBlock> blocks, std::span<const StretchRecord> records,
                          const float* inverse_masses);
    void (*weigh_bend)(std::span<BendBlock> blocks, std::span<const BendRecord> records, int interval,
                       const float* inverse_masses);

    // What refined triangles move their corners by. masses: of a corner with all that follows it, kg; 0: cannot move.
    void (*weigh_limits)(std::span<LimitBlock> blocks, std::span<const LimitRecord> records, const float* masses);

    // Verlet: before := points, points += keep (points - before) + fall.
    void (*predict)(float* points, float* before, std::size_t count, const Motion& motion);

    // One pass over warp, weft and shear; with `records` the multipliers are kept. The blocks in which warp or
    // weft was beyond the fabric's strain limit go into `over`, which has room for all; returns how many.
    std::size_t (*solve_stretch)(std::span<const StretchBlock> blocks, StretchRecord* records, float* points,
                                 std::uint32_t* over);

    // Takes back what warp and weft in the blocks `over` are beyond the fabric's strain limit.
    void (*limit_stretch)(std::span<const StretchBlock> blocks, std::span<const std::uint32_t> over, float* points);

    // One pass over hinges.
    void (*solve_bend)(std::span<const BendBlock> blocks, float* points);

    // Takes back what warp and weft of refined triangles are longer than they may be.
    void (*limit_parents)(std::span<const LimitBlock> blocks, float* points);

    // Moves the centres by half of what the ends of their edges moved since `before`.
    void (*carry_centres)(std::span<const EdgeCentre> centres, const float* before, float* points);

    // Moves each bias towards the one with which strain and stress agree with the fabric.
    void (*update_bias)(std::span<StretchBlock> blocks, std::span<const StretchRecord> records, const float* points,
                        const float* before, const BiasGains& gains);

    // Threads rub against each other: corners lose a share of what they moved against one another since `before`, the
    // cloth as a whole nothing.
    void (*rub)(std::span<const StretchBlock> blocks, const float* points, float* before, float share);

    // Shortens what moved too far since `before`; then finds the movable points that are farther from where they last
    // asked the body than their slack (asked: that place, and fourth the slack in m; below 0: ask now), or too low.
    // Their offsets go into `found`; returns how many. Pre: found has room for all.
    std::size_t (*hold_moves)(float* points, const float* before, const float* asked, std::size_t count,
                              const MoveLimits& limits, std::uint32_t* found);

    // Moves sixteen points out of the body, takes off tangential motion since `before` by up to friction times the
    // depth, and notes where they asked. friction: by vertex.
    void (*reply)(const ContactReply& said, const std::uint32_t* offsets, const float* friction, const float* before,
                  float* points, float* asked);
};

const Kernels& kernels(SimdLevel level);

// The floats of points, as the loops take them. Pre: there is one.
template <class Point>
float* floats(std::vector<Point>& points) {
    return points.front().data();
}

}  // namespace selvedge
