#pragma once
// The kernels that bound triangles and find pairs with overlapping boxes; for their contracts see kernels.h. Include it
// only in kernel sources (kernels_simd.cpp; see sim/core/simd_level.h).
#include "sim/core/simd_lanes.h"
#include "sim/selfcontact/kernels.h"

namespace selvedge::sim {
namespace {

using lanes::Floats;
using lanes::Ints;
using lanes::Xyz;

constexpr std::size_t kPacket = kBlock;
constexpr float kTinyArea = 1e-12F;  // m^2, lower bound of a divisor

[[gnu::always_inline]] inline Floats dot(const Xyz& p, const Xyz& q) {
    return lanes::multiply_add(p.x, q.x, lanes::multiply_add(p.y, q.y, p.z * q.z));
}
[[gnu::always_inline]] inline Xyz minus(const Xyz& p, const Xyz& q) {
    return {p.x - q.x, p.y - q.y, p.z - q.z};
}
// p + s q
[[gnu::always_inline]] inline Xyz plus(const Xyz& p, Floats s, const Xyz& q) {
    return {lanes::multiply_add(s, q.x, p.x), lanes::multiply_add(s, q.y, p.y), lanes::multiply_add(s, q.z, p.z)};
}
[[gnu::always_inline]] inline Xyz cross(const Xyz& p, const Xyz& q) {
    return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
[[gnu::always_inline]] inline Xyz points_at(const float* from, const std::uint32_t* offsets) {
    return lanes::transposed(lanes::gather_points(from, offsets));
}
[[gnu::always_inline]] inline Xyz lower(const Xyz& a, const Xyz& b) {
    return {lanes::min(a.x, b.x), lanes::min(a.y, b.y), lanes::min(a.z, b.z)};
}
[[gnu::always_inline]] inline Xyz upper(const Xyz& a, const Xyz& b) {
    return {lanes::max(a.x, b.x), lanes::max(a.y, b.y), lanes::max(a.z, b.z)};
}
[[gnu::always_inline]] inline void store_xyz(float* const rows[3], std::size_t at, const Xyz& p) {
    lanes::store(rows[0] + at, p.x);
    lanes::store(rows[1] + at, p.y);
    lanes::store(rows[2] + at, p.z);
}
[[gnu::always_inline]] inline Xyz load_xyz(float* const rows[3], std::size_t at) {
    return {lanes::load(rows[0] + at), lanes::load(rows[1] + at), lanes::load(rows[2] + at)};
}
[[gnu::always_inline]] inline Xyz broadcast_xyz(float* const rows[3], std::size_t at) {
    return {lanes::broadcast(rows[0][at]), lanes::broadcast(rows[1][at]), lanes::broadcast(rows[2][at])};
}

[[gnu::always_inline]] inline void bound_lanes(const TriangleRows& rows, std::size_t at, const float* points,
                                               const Sweep& sweep, float grow) {
    const Xyz frame = {lanes::broadcast(sweep.frame[0]), lanes::broadcast(sweep.frame[1]),
                       lanes::broadcast(sweep.frame[2])};
    const Xyz a = minus(points_at(points, rows.corner[0] + at), frame);
    const Xyz b = minus(points_at(points, rows.corner[1] + at), frame);
    const Xyz c = minus(points_at(points, rows.corner[2] + at), frame);
    const Floats ahead = lanes::broadcast(sweep.substeps);
    const Xyz a1 = plus(a, ahead, points_at(sweep.moves, rows.corner[0] + at));
    const Xyz b1 = plus(b, ahead, points_at(sweep.moves, rows.corner[1] + at));
    const Xyz c1 = plus(c, ahead, points_at(sweep.moves, rows.corner[2] + at));
    const Xyz low = lower(lower(lower(a, b), lower(c, a1)), lower(b1, c1));
    const Xyz high = upper(upper(upper(a, b), upper(c, a1)), upper(b1, c1));
    store_xyz(rows.low, at, {low.x - grow, low.y - grow, low.z - grow});
    store_xyz(rows.high, at, {high.x + grow, high.y + grow, high.z + grow});
    const Floats third = lanes::broadcast(1.0F / 3.0F);
    store_xyz(rows.middle, at, {(a.x + b.x + c.x) * third, (a.y + b.y + c.y) * third, (a.z + b.z + c.z) * third});
    const Xyz normal = cross(minus(b, a), minus(c, a));
    const Floats inverse = 1.0F / lanes::max(lanes::sqrt(dot(normal, normal)), lanes::broadcast(kTinyArea));
    store_xyz(rows.normal, at, {normal.x * inverse, normal.y * inverse, normal.z * inverse});
}

void bound_packet(const TriangleRows& rows, std::size_t packet, const float* points, const Sweep& sweep, float grow) {
    const std::size_t first = packet * kPacket;
    for (std::size_t i = 0; i < kPacket; i += lanes::kCount) bound_lanes(rows, first + i, points, sweep, grow);
    for (int k = 0; k < 3; ++k) {
        const float* const low = rows.low[k] + first;
        const float* const high = rows.high[k] + first;
        float lowest = low[0], highest = high[0];
        for (std::size_t i = 1; i < kPacket; ++i) {
            lowest = low[i] < lowest ? low[i] : lowest;
            highest = high[i] > highest ? high[i] : highest;
        }
        rows.packet_low[k][packet] = lowest;
        rows.packet_high[k][packet] = highest;
    }
}

// Comparison: whether the boxes from `at` on overlap a box.
[[gnu::always_inline]] inline Ints overlap(float* const lows[3], float* const highs[3], std::size_t at, const Xyz& low,
                                           const Xyz& high) {
    const Xyz a = load_xyz(lows, at), b = load_xyz(highs, at);
    return (a.x <= high.x) & (b.x >= low.x) & (a.y <= high.y) & (b.y >= low.y) & (a.z <= high.z) & (b.z >= low.z);
}

// Sixteen boxes, as bits.
[[gnu::always_inline]] inline unsigned overlapping(float* const lows[3], float* const highs[3], std::size_t first,
                                                   const Xyz& low, const Xyz& high) {
    unsigned found = 0;
    for (std::size_t i = 0; i < kPacket; i += lanes::kCount) {
        found |= lanes::bits(overlap(lows, highs, first + i, low, high)) << i;
    }
    return found;
}

// Whether the triangles from `at` on cannot touch triangle t. All edges near both are bent by less than a limit. Then
// two triangles with a common vertex cannot touch if they face the same way; nor can two of one sheet that face
// the same way and are apart by more than half of their distance in the material.
[[gnu::always_inline]] inline Ints are_apart(const TriangleRows& rows, std::size_t t, std::size_t at) {
    const Ints flat = lanes::load_ints(rows.is_flat + at) & lanes::broadcast_ints(static_cast<int>(rows.is_flat[t]));
    const Floats facing = dot(load_xyz(rows.normal, at), broadcast_xyz(rows.normal, t));
    Ints shares{};
    for (const auto* const mine : rows.sewn) {
        const Ints vertex = lanes::broadcast_ints(static_cast<int>(mine[t]));
        for (const auto* const theirs : rows.sewn) shares |= lanes::load_ints(theirs + at) == vertex;
    }
    const Xyz between = minus(load_xyz(rows.middle, at), broadcast_xyz(rows.middle, t));
    const Floats u = lanes::load(rows.u + at) - rows.u[t], v = lanes::load(rows.v + at) - rows.v[t];
    const Ints is_same = lanes::load_ints(rows.sheet + at) == lanes::broadcast_ints(static_cast<int>(rows.sheet[t]));
    const Ints is_wide = 4.0F * dot(between, between) > u * u + v * v;
    return flat & ((shares & (facing > 0.0F)) | (is_same & is_wide & (facing > 0.5F)));
}

// Appends the pairs of triangle t with the triangles of the packet that starts at `other`; within its own packet, with
// later ones.
[[gnu::always_inline]] inline std::size_t pair_up(const TriangleRows& rows, std::size_t t, std::size_t other,
                                                  TrianglePair* pairs) {
    const Xyz low = broadcast_xyz(rows.low, t), high = broadcast_xyz(rows.high, t);
    std::size_t count = 0;
    for (std::size_t at = other; at < other + kPacket; at += lanes::kCount) {
        unsigned found = lanes::bits(overlap(rows.low, rows.high, at, low, high));
        if (other == t / kPacket * kPacket && at <= t) {
            found &= t - at + 1 >= lanes::kCount ? 0U : ~0U << (t - at + 1);
        }
        if (found != 0) found &= ~lanes::bits(are_apart(rows, t, at));
        for (; found != 0; found &= found - 1) {
            const std::size_t second = at + static_cast<std::size_t>(__builtin_ctz(found));
            pairs[count++] = {static_cast<std::uint32_t>(t), static_cast<std::uint32_t>(second)};
        }
    }
    return count;
}

std::size_t find_pairs(const TriangleRows& rows, std::size_t packet, const std::uint32_t* asked, TrianglePair* pairs) {
    std::size_t count = 0;
    const std::size_t packets = rows.padded / kPacket, first = packet * kPacket;
    const Xyz low = broadcast_xyz(rows.packet_low, packet), high = broadcast_xyz(rows.packet_high, packet);
    for (std::size_t row = 0; row < packets; row += kPacket) {
        unsigned near = overlapping(rows.packet_low, rows.packet_high, row, low, high);
        if (row < packet) {
            const unsigned later = packet - row < kPacket ? ~0U << (packet - row) : 0U;
            near &= later | ~asked[row / kPacket];
        }
        for (; near != 0; near &= near - 1) {
            const std::size_t other = row + static_cast<std::size_t>(__builtin_ctz(near));
            unsigned mine = overlapping(rows.low, rows.high, first, broadcast_xyz(rows.packet_low, other),
                                        broadcast_xyz(rows.packet_high, other));
            for (; mine != 0; mine &= mine - 1) {
                const std::size_t t = first + static_cast<std::size_t>(__builtin_ctz(mine));
                count += pair_up(rows, t, other * kPacket, pairs + count);
            }
        }
    }
    return count;
}

struct Triangles {
    Xyz p[3];
};
[[gnu::always_inline]] inline Xyz low_corner(const Triangles& t) {
    return lower(t.p[0], lower(t.p[1], t.p[2]));
}
[[gnu::always_inline]] inline Xyz high_corner(const Triangles& t) {
    return upper(t.p[0], upper(t.p[1], t.p[2]));
}

// Whether the other triangles are on one side of the planes of these, by more than rounding.
[[gnu::always_inline]] inline Ints is_on_one_side(const Triangles& planes, const Triangles& others) {
    constexpr float kRounding = 1e-6F;  // m
    const Xyz normal = cross(minus(planes.p[1], planes.p[0]), minus(planes.p[2], planes.p[0]));
    const Floats off = lanes::sqrt(dot(normal, normal)) * kRounding;
    const Floats a = dot(normal, minus(others.p[0], planes.p[0])), b = dot(normal, minus(others.p[1], planes.p[0])),
                 c = dot(normal, minus(others.p[2], planes.p[0]));
    return (lanes::min(a, lanes::min(b, c)) > off) | (lanes::max(a, lanes::max(b, c)) < -off);
}

[[gnu::always_inline]] inline unsigned piercing_lanes(const TriangleRows& rows, const TrianglePair* pairs,
                                                      const float* points) {
    Triangles first, second;
    for (int k = 0; k < 3; ++k) {
        std::uint32_t mine[lanes::kCount], theirs[lanes::kCount];
        for (std::size_t i = 0; i < lanes::kCount; ++i) {
            mine[i] = rows.corner[k][pairs[i].first];
            theirs[i] = rows.corner[k][pairs[i].second];
        }
        first.p[k] = points_at(points, mine);
        second.p[k] = points_at(points, theirs);
    }
    const Xyz low = low_corner(first), high = high_corner(first), bottom = low_corner(second),
              top = high_corner(second);
    const Ints meets = (low.x <= top.x) & (high.x >= bottom.x) & (low.y <= top.y) & (high.y >= bottom.y) &
                       (low.z <= top.z) & (high.z >= bottom.z);
    return lanes::bits(meets & ~is_on_one_side(first, second) & ~is_on_one_side(second, first));
}

unsigned find_piercing(const TriangleRows& rows, const TrianglePair* pairs, const float* points) {
    unsigned found = 0;
    for (std::size_t i = 0; i < kPacket; i += lanes::kCount) found |= piercing_lanes(rows, pairs + i, points) << i;
    return found;
}

}  // namespace
}  // namespace selvedge::sim
