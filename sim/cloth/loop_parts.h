#pragma once
// Functions shared by constraint_loops.h, contact_loops.h and triangle_bending_loops.h. Include it only in kernel
// sources (kernels_simd.cpp; see sim/core/simd_level.h).
#include <cstring>

#include "sim/cloth/kernels.h"
#include "sim/core/simd_lanes.h"

namespace selvedge::sim {
namespace {

using lanes::Floats;
using lanes::Ints;
using lanes::Rows;
using lanes::Xyz;

constexpr float kTiny = 1e-18F;  // added under square roots (m^2), or a lower bound of divisors
constexpr float kMoreShear = 4;  // ratio of the bounds of the shear bias to those of warp and weft; by experiment

[[gnu::always_inline]] inline Floats load_at(const BlockFloats& values, std::size_t at) {
    return lanes::load(&values[at]);
}

[[gnu::always_inline]] inline Floats dot(const Xyz& p, const Xyz& q) {
    return lanes::multiply_add(p.x, q.x, lanes::multiply_add(p.y, q.y, p.z * q.z));
}
[[gnu::always_inline]] inline Xyz combined(const Xyz& p, Floats s, const Xyz& q, Floats t) {
    return {lanes::multiply_add(p.x, s, q.x * t), lanes::multiply_add(p.y, s, q.y * t),
            lanes::multiply_add(p.z, s, q.z * t)};
}
[[gnu::always_inline]] inline Rows difference(const Rows& a, const Rows& b) {
    return {{a.row[0] - b.row[0], a.row[1] - b.row[1], a.row[2] - b.row[2], a.row[3] - b.row[3]}};
}
// Each point moved by its inverse mass times its entry in `by`, whose w components are 0.
[[gnu::always_inline]] inline Rows pushed(const Rows& p, const Rows& by) {
    Rows moved;
    for (int j = 0; j < 4; ++j) moved.row[j] = lanes::multiply_add(by.row[j], lanes::w_components(p.row[j]), p.row[j]);
    return moved;
}

// Gathers a per-vertex value for one corner of each constraint.
[[gnu::always_inline]] inline Floats value_at(const BlockPoints& corners, std::size_t at, const float* by_vertex) {
    return lanes::gather(by_vertex, lanes::load_ints(&corners[at]) >> 2);
}

// Whether `holds` is true for at least one of a block's sixteen values.
template <class Holds>
[[gnu::always_inline]] inline bool has_lane(const BlockFloats& values, const Holds& holds) {
    unsigned found = 0;
    for (std::size_t at = 0; at < kBlock; at += lanes::kCount) found |= lanes::bits(holds(load_at(values, at)));
    return found != 0;
}
[[gnu::always_inline]] inline bool has_positive(const BlockFloats& values) {
    return has_lane(values, [](Floats value) { return value > 0.0F; });
}

// `value` clamped to [-reach, reach].
[[gnu::always_inline]] inline Floats clamped(Floats value, Floats reach) {
    return lanes::min(lanes::max(value, -reach), reach);
}

// The deformed warp and weft directions of triangles, as unit vectors after normalise(), and their lengths.
struct YarnDirections {
    Xyz warp, weft;
    Floats warp_length, weft_length;
    Floats warp_arm, weft_arm;  // min(length, 1): a short yarn rotates further per displacement, so it moves less
};

template <class Block>
[[gnu::always_inline]] inline YarnDirections directions(const Block& block, std::size_t at, const Rows& x0,
                                                        const Rows& x1, const Rows& x2) {
    const Xyz e1 = lanes::transposed(difference(x1, x0));
    const Xyz e2 = lanes::transposed(difference(x2, x0));
    return {.warp = combined(e1, load_at(block.a[0], at), e2, load_at(block.a[1], at)),
            .weft = combined(e1, load_at(block.b[0], at), e2, load_at(block.b[1], at)),
            .warp_length = Floats{},
            .weft_length = Floats{},
            .warp_arm = Floats{},
            .weft_arm = Floats{}};
}

[[gnu::always_inline]] inline Floats normalise(Xyz& p) {
    const Floats squared = lanes::multiply_add(
        p.x, p.x, lanes::multiply_add(p.y, p.y, lanes::multiply_add(p.z, p.z, lanes::broadcast(kTiny))));
    const Floats inverse = lanes::inverse_root(squared);
    p = {p.x * inverse, p.y * inverse, p.z * inverse};
    return squared * inverse;
}

[[gnu::always_inline]] inline void normalise(YarnDirections& t) {
    t.warp_length = normalise(t.warp);
    t.weft_length = normalise(t.weft);
    t.warp_arm = lanes::min(t.warp_length, lanes::broadcast(1.0F));
    t.weft_arm = lanes::min(t.weft_length, lanes::broadcast(1.0F));
}

struct Corners {
    Rows x0, x1, x2;
};
template <class Block>
[[gnu::always_inline]] inline Corners corners_of(const Block& block, std::size_t at, const float* points) {
    return {lanes::gather_points(points, &block.vertices[0][at]), lanes::gather_points(points, &block.vertices[1][at]),
            lanes::gather_points(points, &block.vertices[2][at])};
}
template <class Block>
[[gnu::always_inline]] inline void put_corners(const Block& block, std::size_t at, const Corners& c, float* points) {
    lanes::scatter_points(points, &block.vertices[0][at], c.x0);
    lanes::scatter_points(points, &block.vertices[1][at], c.x1);
    lanes::scatter_points(points, &block.vertices[2][at], c.x2);
}

// The mean of the positions at two successive sub-steps. It filters out oscillation from one sub-step to the next.
[[gnu::always_inline]] inline Rows middle(const Rows& a, const Rows& b) {
    Rows sum;
    for (int j = 0; j < 4; ++j) sum.row[j] = (a.row[j] + b.row[j]) * lanes::broadcast(0.5F);
    return sum;
}

// The yarn directions of triangles, from the mean positions of two successive sub-steps.
template <class Block>
[[gnu::always_inline]] inline YarnDirections mean_directions(const Block& block, std::size_t at, const float* points,
                                                             const float* before) {
    const Corners c = corners_of(block, at, points);
    const Corners was = corners_of(block, at, before);
    YarnDirections t = directions(block, at, middle(c.x0, was.x0), middle(c.x1, was.x1), middle(c.x2, was.x2));
    normalise(t);
    return t;
}

// Three values per lane.
using Three = std::array<BlockFloats, 3>;
[[gnu::always_inline]] inline Xyz load_three(const Three& rows, std::size_t at) {
    return {load_at(rows[0], at), load_at(rows[1], at), load_at(rows[2], at)};
}
[[gnu::always_inline]] inline void store_three(Three& rows, std::size_t at, Floats a, Floats b, Floats c) {
    lanes::store(&rows[0][at], a);
    lanes::store(&rows[1][at], b);
    lanes::store(&rows[2][at], c);
}

[[gnu::always_inline]] inline void move_bias(BlockFloats& bias, std::size_t at, Floats error, float gain, Floats least,
                                             float most) {
    const Floats moved = lanes::load(&bias[at]) + error * lanes::broadcast(gain);
    lanes::store(&bias[at], lanes::min(lanes::max(moved, least), lanes::broadcast(most)));
}

}  // namespace
}  // namespace selvedge::sim
