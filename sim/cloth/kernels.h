#pragma once
// The inner loops of a sub-step (kernels), compiled once for each SIMD level. sim/core/simd_level.h says which levels
// give the same bits.
//
// Points are four floats: x, y, z in metres and w, the inverse mass (1/kg), which is 0 for a vertex that cannot move.
#include <cstddef>
#include <cstdint>
#include <span>

#include "sim/cloth/contact.h"
#include "sim/cloth/solver_blocks.h"
#include "sim/collide/collider.h"
#include "sim/core/simd_level.h"

namespace selvedge::sim {

struct Motion {
    float keep = 1;               // factor on the last displacement: 1 - damping h
    std::array<float, 3> fall{};  // m, displacement that each sub-step adds: acceleration times h^2
};

// Arrays by vertex, four floats each.
struct CorrectedPoints {
    float* points = nullptr;
    float* predicted = nullptr;   // positions before the corrections by stretch and shear
    float* start = nullptr;       // predicted plus the momentum of corrections
    float* correction = nullptr;  // displacement by the corrections of stretch and shear
};

// Gains of the update of the biases, and bounds, which were chosen by experiment.
struct BiasGains {
    float stretch = 0;  // share of the strain error that is added to the bias of warp and weft
    float shear = 0;
    float least = -0.02F;  // minimum for warp and weft: cloth held compressed must not accumulate a greater length
    float most = 0.3F;     // maximum for warp and weft
};

// The arrays of LevelStress. below and off are all zero before and after the update of the biases.
struct StressSums {
    const float* above = nullptr;
    float* below = nullptr;
    float* off = nullptr;
};

struct ContactLimits {
    float longest_move = 0;  // m per sub-step
    float floor = 0;         // m: height of the floor's offset surface
    float offset = 0;        // m, distance kept from the body
    float margin = 0;        // m, by which a collider's distance may be too large
    float friction_scale = 1;
};

// For sixteen samples: which must query the collider, a bit per slot, whether any touches according to the contact
// cache, and how far they may move before one can do either.
struct SampleState {
    unsigned to_query;
    bool touches;
    float free;  // m; 0 if any has to query or touches
};

struct Kernels {
    // Update the gains of constraints from the inverse masses of their vertices (1/kg; 0: cannot move), after an
    // adaptation.
    void (*update_stretch_masses)(std::span<StretchBlock> blocks, std::span<const StretchRecord> records,
                                  const float* inverse_masses);
    void (*update_bend_masses)(std::span<BendBlock> blocks, std::span<BendRecord> records, const float* inverse_masses);

    // The same for refined triangles. masses: effective mass of a vertex with all vertices that follow it, kg; 0:
    // cannot move.
    void (*update_coarse_bend_masses)(std::span<CoarseBendBlock> blocks, std::span<BendRecord> records,
                                      const float* masses);

    // Updates the gains of the coarse strain limits of refined triangles. masses: as above.
    void (*update_limit_masses)(std::span<LimitBlock> blocks, std::span<LimitRecord> records, const float* masses);

    // Verlet: before := points, points += keep (points - before) + fall. The rounding error of a displacement is stored
    // in `lost` and added to the next one (compensated summation): a displacement is only a few units in the last place
    // of a float long, so that otherwise 1 % of gravity would be lost.
    void (*predict)(float* points, float* before, float* lost, std::size_t count, const Motion& motion);

    // add_momentum: predicted := points, points += momentum * correction, start := points.
    // store_corrections: correction := points - predicted.
    void (*add_momentum)(const CorrectedPoints& corrected, std::size_t count, float momentum);
    void (*store_corrections)(const CorrectedPoints& corrected, std::size_t count);

    // One iteration over warp, weft and shear; also moves the anchors of friction. If `records` is given, the
    // multipliers are stored there. Constraints in which warp or weft was beyond the fabric's strain limit are copied
    // into `over`, which has room for as many blocks; returns the number of blocks used. Pre: all blocks have one
    // colour. dummy: a block of dummy constraints, for padding.
    std::size_t (*solve_stretch)(std::span<StretchBlock> blocks, StretchRecord* records, float* points, OverBlock* over,
                                 const OverBlock& dummy);

    // Shortens warp and weft to the fabric's strain limit where they are longer.
    void (*limit_stretch)(std::span<const OverBlock> blocks, float* points);

    // One iteration over the bending of triangles; also moves the anchors of friction. Solves only triangles whose
    // BendBlock::interval is at most `interval`; that excludes refined triangles to which no rigidity was passed up.
    void (*solve_bend)(std::span<BendBlock> blocks, float* points, int interval);
    void (*solve_coarse_bend)(std::span<CoarseBendBlock> blocks, float* points, int interval);

    // One iteration of the coarse strain limits: shortens warp and weft of refined triangles where they are too long,
    // with a bounded shear correction. If `records` is given, the multipliers are stored there.
    void (*solve_coarse_limits)(std::span<const LimitBlock> blocks, LimitRecord* records, float* points);

    // Prolongation to the centres of split edges: moves each by the mean displacement of the edge's ends since
    // `before`.
    void (*prolong_centres)(std::span<const EdgeCentre> centres, const float* before, float* points);

    // Sums the stress that a refined triangle and all its ancestors bear, from the last multipliers, into `above` of
    // LevelStress. Called level by level, coarse to fine.
    void (*prolong_stress)(std::span<const LimitRecord> records, float* above);

    // Update the biases so that the strain approaches the one that the fabric has under the total stress of a leaf and
    // all its ancestors. The bias of a leaf follows its own strain error. Of a refined triangle, warp and weft follow
    // the mean strain error of its leaves, and shear follows the triangle's share of the tension. Called for the leaves
    // first, then for the refined triangles, fine to coarse.
    void (*update_bias)(std::span<StretchBlock> blocks, std::span<const StretchRecord> records, const float* points,
                        const float* before, const BiasGains& gains, const StressSums& sums);
    void (*update_limit_biases)(std::span<LimitBlock> blocks, std::span<LimitRecord> records, const BiasGains& gains,
                                const StressSums& sums);

    // Internal damping: the corners of a triangle lose a share of their relative motion since `before`. Linear momentum
    // is conserved.
    void (*apply_internal_damping)(std::span<const StretchBlock> blocks, const float* points, float* before,
                                   float share);

    // Limits the displacement of each point since `before`. Then projects points that are below the floor, or that
    // touch the body according to the contact cache, onto the offset surface; friction reduces the tangential motion
    // since `before` by up to the coefficient times the depth. The offsets of the movable points that must query the
    // collider are written to `found`; returns their number. Pre: `count` is a multiple of sixteen; found has
    // room for all points.
    std::size_t (*project_vertices)(float* points, const float* before, const ContactCacheArrays& known,
                                    const float* friction, std::size_t count, const ContactLimits& limits,
                                    std::uint32_t* found);

    // Projects sixteen points with the collider's results in `said`, and stores these in the contact cache.
    void (*store_query_and_project)(const ContactBlock& result, const std::uint32_t* offsets, const float* friction,
                                    const ContactLimits& limits, const float* before, float* points,
                                    const ContactCacheArrays& known);

    // Three steps for sixteen samples: computes their positions for a collider query; stores the results of the query
    // in the contact cache; projects those that touch.
    SampleState (*locate_samples)(const SampleBlock& block, const float* points, ContactBlock& at_points);
    void (*store_query)(const ContactBlock& result, const ContactLimits& limits, SampleBlock& block);
    void (*push_samples)(SampleBlock& block, const ContactLimits& limits, float* points, float* before);

    // For a block in turn: projects the samples that touch one by one, from slot `first` on, until one must query the
    // collider. Returns the slot of that one, or kBlock.
    std::size_t (*push_samples_in_turn)(SampleBlock& block, std::size_t first, const ContactLimits& limits,
                                        float* points, float* before);

    // The longest displacement of a point since `last`, m; then last := points. Pre: `count` is a multiple of sixteen.
    float (*longest_motion)(const float* points, float* last, std::size_t count);

    // The same with planes that move: projects the points that are below them, with friction against the motion of the
    // planes since `before`. What a vertex gains by the rise of its plane is added to `before` too.
    void (*hold_on_planes)(std::span<const MovingVertexBlock> blocks, const StepShare& share, float friction_scale,
                           float* before, float* points);
    void (*push_samples_on_planes)(SampleBlock& block, const MovingSideBlock& sides, const StepShare& share,
                                   float friction_scale, float* points, float* before);
};

const Kernels& kernels(SimdLevel level);

// The kernels of one level, defined by the compilation of kernels_simd.cpp for that level.
template <SimdLevel>
const Kernels& kernels_of();

// The points as an array of floats, as the kernels take them. Pre: not empty.
template <class Point>
float* floats(std::vector<Point>& points) {
    return points.front().data();
}

}  // namespace selvedge::sim
