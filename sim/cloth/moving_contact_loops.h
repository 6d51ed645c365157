#pragma once
// The kernels of contacts with planes that move; for their contracts see kernels.h. Include it only in kernel sources
// (kernels_simd.cpp; see sim/core/simd_level.h).
#include "sim/cloth/contact_loops.h"

namespace selvedge::sim {
namespace {

// The sides of the body at the end of a sub-step, as the points x meet them; as the function of one side does.
[[gnu::always_inline]] inline MovedPlanes met(const MovingSideBlock& sides, std::size_t at, const Xyz& x,
                                              const StepShare& share) {
    const Xyz point = load_three(sides.start.point, at), motion = load_three(sides.motion, at);
    const Floats end = lanes::broadcast(share.end), one = lanes::broadcast(1.0F);
    const Floats length = lanes::broadcast(share.length), rise = load_at(sides.rise, at);
    Xyz normal = combined(load_three(sides.start.normal, at), one, load_three(sides.turn, at), end);
    normalise(normal);
    const Floats kept = rise * end - load_at(sides.start.height, at);
    const Floats above = dot(normal, ManyPoints::minus(ManyPoints::minus(x, point), motion, end));
    const Floats depth = lanes::max(kept - above, Floats{});
    return {.normal = normal,
            .depth = depth,
            .gained = lanes::min(depth, rise * length),
            .motion = {motion.x * length, motion.y * length, motion.z * length}};
}

void hold_on_planes(std::span<const MovingVertexBlock> blocks, const StepShare& share, float friction_scale,
                    float* before, float* points) {
    const auto put = [](float* to, const std::uint32_t* offsets, const Xyz& x, const Rows& was) {
        Rows rows = lanes::rows_of(x);
        for (int j = 0; j < 4; ++j) rows.row[j] = lanes::with_w_components(rows.row[j], was.row[j]);
        lanes::scatter_points(to, offsets, rows);
    };
    for (const MovingVertexBlock& block : blocks) {
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            const std::uint32_t* const offsets = &block.vertices[at];
            const Rows now = lanes::gather_points(points, offsets);
            const Xyz x = lanes::transposed(now);
            const MovedPlanes side = met(block.side, at, x, share);
            if (lanes::bits(side.depth > 0.0F) == 0) continue;
            const Rows then = lanes::gather_points(before, offsets);
            const Xyz from = lanes::transposed(then);
            put(points, offsets, projected(x, from, side, load_at(block.friction, at) * friction_scale), now);
            if (lanes::bits(side.gained > 0.0F) == 0) continue;
            put(before, offsets, ManyPoints::plus(from, side.normal, side.gained), then);
        }
    }
}

// The corners of a group of samples after their projection; below: the lanes that are below their planes. What samples
// gain by the rise of their planes gives them velocity.
struct CornersOnPlanes {
    Corners corners;
    unsigned below;
};
[[gnu::always_inline]] inline CornersOnPlanes on_planes(const SampleBlock& block, std::size_t at,
                                                        const MovingSideBlock& sides, const StepShare& share,
                                                        float friction_scale, const float* points,
                                                        const float* before) {
    const Corners c = corners_of(block, at, points);
    const Xyz x = mixed(block, at, c);
    MovedPlanes side = met(sides, at, x, share);
    side.gained = Floats{};
    const unsigned below = lanes::bits(side.depth > 0.0F);
    if (below == 0) return {c, below};
    const CornerShares shares = corner_shares(block, at, c);
    const Xyz from = mixed(block, at, corners_of(block, at, before));
    const Xyz out = projected(x, from, side, load_at(block.friction, at) * friction_scale);
    return {shifted(c, ManyPoints::minus(out, x), shares), below};
}

void push_samples_on_planes(SampleBlock& block, const MovingSideBlock& sides, const StepShare& share,
                            float friction_scale, float* points, float* before) {
    const bool is_in_turn = block.in_turn[0] != 0;
    for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
        for (unsigned rest = ~0U; rest != 0;) {
            const CornersOnPlanes to = on_planes(block, at, sides, share, friction_scale, points, before);
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
