#pragma once
// The kernels of contacts with planes that move; for their contracts see kernels.h. Include it only in kernel sources
// (kernels_simd.cpp; see sim/core/simd_level.h).
#include "sim/cloth/contact_loops.h"

namespace selvedge::sim {
namespace {

// Planes at the end of a sub-step.
struct PlanesNow {
    Xyz normal;
    Floats depth;  // of the points below the planes, m; at most 0 above them
    Xyz motion;    // of the surface in this sub-step, m
};

[[gnu::always_inline]] inline PlanesNow planes_now(const MovingPlaneBlock& planes, std::size_t at, const Xyz& x,
                                                   const StepShare& share) {
    const Xyz point = load_three(planes.point, at), motion = load_three(planes.motion, at);
    const Floats end = lanes::broadcast(share.end), one = lanes::broadcast(1.0F);
    Xyz normal = combined(load_three(planes.normal, at), one, load_three(planes.turn, at), end);
    normalise(normal);
    const Xyz now = combined(point, one, motion, end);
    const Xyz above{x.x - now.x, x.y - now.y, x.z - now.z};
    const Floats length = lanes::broadcast(share.length);
    return {.normal = normal,
            .depth = Floats{} - dot(normal, above),
            .motion = {motion.x * length, motion.y * length, motion.z * length}};
}

[[gnu::always_inline]] inline Xyz sum(const Xyz& a, const Xyz& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

void hold_on_planes(std::span<const MovingVertexBlock> blocks, const StepShare& share, float friction_scale,
                    float* before, float* points) {
    for (const MovingVertexBlock& block : blocks) {
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            const Rows was = lanes::gather_points(points, &block.vertices[at]);
            const Xyz x = lanes::transposed(was);
            const PlanesNow now = planes_now(block.plane, at, x, share);
            if (lanes::bits(now.depth > 0.0F) == 0) continue;
            const Xyz from = sum(lanes::transposed(lanes::gather_points(before, &block.vertices[at])), now.motion);
            const Floats mu = load_at(block.friction, at) * friction_scale;
            const Floats depth = lanes::max(now.depth, Floats{});
            const Floats rise = load_at(block.rise, at) * lanes::broadcast(share.length);
            const Floats gained = lanes::min(depth, rise);
            Rows out = lanes::rows_of(project(x, from, now.normal, depth, mu, gained));
            for (int j = 0; j < 4; ++j) out.row[j] = lanes::with_w_components(out.row[j], was.row[j]);
            lanes::scatter_points(points, &block.vertices[at], out);
            if (lanes::bits(rise > 0.0F) == 0) continue;
            const Rows start = lanes::gather_points(before, &block.vertices[at]);
            const Xyz b = lanes::transposed(start);
            Rows moved =
                lanes::rows_of({b.x + now.normal.x * gained, b.y + now.normal.y * gained, b.z + now.normal.z * gained});
            for (int j = 0; j < 4; ++j) moved.row[j] = lanes::with_w_components(moved.row[j], start.row[j]);
            lanes::scatter_points(before, &block.vertices[at], moved);
        }
    }
}

// The corners of a group of samples after their projection; below: the lanes that are below their planes.
struct CornersOnPlanes {
    Corners corners;
    unsigned below;
};
[[gnu::always_inline]] inline CornersOnPlanes on_planes(const SampleBlock& block, std::size_t at,
                                                        const MovingPlaneBlock& planes, const StepShare& share,
                                                        float friction_scale, const float* points,
                                                        const float* before) {
    const Corners c = corners_of(block, at, points);
    const Xyz x = mixed(block, at, c);
    const PlanesNow now = planes_now(planes, at, x, share);
    const unsigned below = lanes::bits(now.depth > 0.0F);
    if (below == 0) return {c, below};
    const CornerShares shares = corner_shares(block, at, c);
    const Xyz from = sum(mixed(block, at, corners_of(block, at, before)), now.motion);
    const Floats mu = load_at(block.friction, at) * friction_scale;
    const Xyz out = project(x, from, now.normal, lanes::max(now.depth, Floats{}), mu);
    return {shifted(c, {out.x - x.x, out.y - x.y, out.z - x.z}, shares), below};
}

void push_samples_on_planes(SampleBlock& block, const MovingPlaneBlock& planes, const StepShare& share,
                            float friction_scale, float* points, float* before) {
    const bool is_in_turn = block.in_turn[0] != 0;
    for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
        for (unsigned rest = ~0U; rest != 0;) {
            const CornersOnPlanes to = on_planes(block, at, planes, share, friction_scale, points, before);
            if ((to.below & rest) == 0) break;
            if (!is_in_turn) {
                put_corners(block, at, to.corners, points);
                break;
            }
            const auto lane = static_cast<std::size_t>(__builtin_ctz(to.below & rest));
            put_lane(block, at, lane, to.corners, points);
            rest &= lanes_after(lane);
        }
    }
}

}  // namespace
}  // namespace selvedge::sim
