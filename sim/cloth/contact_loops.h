#pragma once
// The kernels of contacts, which keep vertices and samples outside of a body, and vertices above the floor; for their
// contracts see kernels.h. Include it only in kernel sources (kernels_simd.cpp; see sim/core/simd_level.h).
#include "sim/cloth/loop_parts.h"

namespace selvedge::sim {
namespace {

// For points as stored in memory (x, y, z, w): the squared length of each, in all four of its lanes.
[[gnu::always_inline]] inline Floats squared_lengths(Floats move) {
    const Floats squares = move * move;
    const Floats pairs = squares + lanes::shuffle<0xB1>(squares, squares);
    return pairs + lanes::shuffle<0x4E>(pairs, pairs);
}

// Scales displacements down to the maximum length.
[[gnu::always_inline]] inline Floats shortened(Floats move, Floats longest_squared) {
    const Floats squared = squared_lengths(move);
    if (lanes::bits(squared > longest_squared) == 0) [[likely]]
        return move;
    return move * lanes::sqrt(longest_squared / lanes::max(squared, longest_squared + lanes::broadcast(kTiny)));
}

// The result of looking up points in the contact cache.
struct ContactCache {
    Xyz normal;
    Floats height;     // above the offset surface, m, by the tangent plane
    Ints needs_query;  // the point must query the collider
    Ints is_known;     // the point has used up its slack, and the tangent plane is valid
    Ints may_touch;    // is_known, and the point is below the offset surface
};

// x: the present positions; the other arguments: their entries in the contact cache.
[[gnu::always_inline]] inline ContactCache near(const Xyz& x, const Xyz& query_point, Floats slack, const Xyz& normal,
                                                Floats height) {
    const Xyz moved{x.x - query_point.x, x.y - query_point.y, x.z - query_point.z};
    const Floats squared = dot(moved, moved);
    const Floats free = lanes::max(slack, Floats{});
    const Ints is_near = squared >= free * free;
    const Ints is_lost = (squared > kPlaneReach * kPlaneReach) | (slack < ContactCacheArrays::kInvalidBelow);
    const Floats now = height + dot(normal, moved);
    const Ints is_known = is_near & ~is_lost;
    return {normal, now, is_near & is_lost, is_known, is_known & (now < 0.0F)};
}

// Projects points that lie `depth` below the offset surface (0: above it) onto that surface, and reduces their
// tangential displacement since `from` by friction times depth.
[[gnu::always_inline]] inline Xyz project(const Xyz& x, const Xyz& from, const Xyz& normal, Floats depth,
                                          Floats friction) {
    const Xyz out{x.x + normal.x * depth, x.y + normal.y * depth, x.z + normal.z * depth};
    const Xyz moved{out.x - from.x, out.y - from.y, out.z - from.z};
    const Floats along = dot(moved, normal);
    const Xyz slid{moved.x - normal.x * along, moved.y - normal.y * along, moved.z - normal.z * along};
    const Floats inverse = lanes::inverse_root(dot(slid, slid) + lanes::broadcast(kTiny));
    const Floats taken = lanes::min(friction * depth * inverse, lanes::broadcast(1.0F));
    return {out.x - slid.x * taken, out.y - slid.y * taken, out.z - slid.z * taken};
}

// Loads kCount consecutive points. After transposition lane 4 k + j holds point kCount / 4 j + k.
[[gnu::always_inline]] inline Rows rows_at(const float* points) {
    Rows rows;
    for (std::size_t j = 0; j < 4; ++j) rows.row[j] = lanes::load(points + j * lanes::kCount);
    return rows;
}
constexpr std::size_t lane_of_point(std::size_t i) {
    constexpr std::size_t kPerRow = lanes::kCount / 4;
    return 4 * (i % kPerRow) + i / kPerRow;
}
[[gnu::always_inline]] inline Floats w_of(const Rows& p) {
    const Floats zw01 = lanes::unpack_high(p.row[0], p.row[1]);
    const Floats zw23 = lanes::unpack_high(p.row[2], p.row[3]);
    return lanes::shuffle<0xEE>(zw01, zw23);
}

// Limits the displacements of a group of points since `from` to the maximum length.
[[gnu::always_inline]] inline Rows shortened(const Rows& was, const Rows& from, Floats longest_squared) {
    Rows rows;
    for (std::size_t j = 0; j < 4; ++j) {
        const Floats move = shortened(was.row[j] - from.row[j], longest_squared);
        rows.row[j] = lanes::with_w_components(from.row[j] + move, was.row[j]);
    }
    return rows;
}

[[gnu::always_inline]] inline Floats friction_of(const float* friction, float scale) {
    Floats mu{};
    for (std::size_t i = 0; i < lanes::kCount; ++i) mu[lane_of_point(i)] = friction[i] * scale;
    return mu;
}

// Projects points that are below the floor, then those that touch the body. So a point between both ends up outside of
// the body.
[[gnu::always_inline]] inline Rows held(const Xyz& x, const Rows& was, const Rows& from, const ContactCache& known,
                                        Ints below, const float* friction, const ContactLimits& limits) {
    const Xyz before = lanes::transposed(from);
    const Floats mu = friction_of(friction, limits.friction_scale);
    const Xyz up{Floats{}, lanes::broadcast(1.0F), Floats{}};
    const Xyz above = project(x, before, up, lanes::where(below, limits.floor - x.y), mu);
    const Xyz lift{above.x - x.x, above.y - x.y, above.z - x.z};
    const Floats height = lanes::min(known.height + dot(known.normal, lift), Floats{});
    const Xyz out = project(above, before, known.normal, lanes::where(known.is_known, -height), mu);
    return lanes::rows_of(out, w_of(was));
}

std::size_t project_vertices(float* points, const float* before, const ContactCacheArrays& known, const float* friction,
                             std::size_t count, const ContactLimits& limits, std::uint32_t* found) {
    const Floats longest_squared = lanes::broadcast(limits.longest_move * limits.longest_move);
    std::size_t n = 0;
    for (std::size_t first = 0; first < count; first += lanes::kCount) {
        const std::size_t i = 4 * first;
        const Rows from = rows_at(before + i);
        const Rows was = shortened(rows_at(points + i), from, longest_squared);
        for (std::size_t j = 0; j < 4; ++j) lanes::store(points + i + j * lanes::kCount, was.row[j]);
        const Xyz x = lanes::transposed(was);
        const Rows query_point = rows_at(known.query_point + i), plane = rows_at(known.plane + i);
        ContactCache here =
            near(x, lanes::transposed(query_point), w_of(query_point), lanes::transposed(plane), w_of(plane));
        const Ints moves = w_of(was) > 0.0F;
        const Ints below = (x.y < limits.floor) & moves;
        here.may_touch &= moves;
        here.is_known &= moves;
        if (lanes::bits(here.may_touch | below) != 0) {
            const Rows out = held(x, was, from, here, below, friction + first, limits);
            for (std::size_t j = 0; j < 4; ++j) lanes::store(points + i + j * lanes::kCount, out.row[j]);
        }
        const unsigned to_query = lanes::bits(here.needs_query & moves);
        if (to_query == 0) [[likely]]
            continue;
        for (std::size_t k = 0; k < lanes::kCount; ++k) {
            if ((to_query >> lane_of_point(k) & 1U) != 0) found[n++] = static_cast<std::uint32_t>(i + 4 * k);
        }
    }
    return n;
}

[[gnu::always_inline]] inline Xyz load_xyz(const ContactBlock& result, std::size_t at) {
    return {lanes::load(&result.x[at]), lanes::load(&result.y[at]), lanes::load(&result.z[at])};
}
[[gnu::always_inline]] inline Xyz load_normal(const ContactBlock& result, std::size_t at) {
    return {lanes::load(&result.nx[at]), lanes::load(&result.ny[at]), lanes::load(&result.nz[at])};
}

void store_query_and_project(const ContactBlock& result, const std::uint32_t* offsets, const float* friction,
                             const ContactLimits& limits, const float* before, float* points,
                             const ContactCacheArrays& known) {
    for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
        Floats mu{};
        for (std::size_t i = 0; i < lanes::kCount; ++i) mu[i] = friction[offsets[at + i] / 4] * limits.friction_scale;
        const Xyz x = load_xyz(result, at), normal = load_normal(result, at);
        const Floats height = lanes::load(&result.distance[at]) - limits.offset;
        const Floats depth = lanes::max(-height, Floats{});
        const Xyz from = lanes::transposed(lanes::gather_points(before, offsets + at));
        const Rows as_it_was = lanes::gather_points(points, offsets + at);
        Rows moved = lanes::rows_of(project(x, from, normal, depth, mu));
        for (int j = 0; j < 4; ++j) moved.row[j] = lanes::with_w_components(moved.row[j], as_it_was.row[j]);
        lanes::scatter_points(points, offsets + at, moved);
        lanes::scatter_points(known.query_point, offsets + at, lanes::rows_of(x, height - limits.margin));
        lanes::scatter_points(known.plane, offsets + at, lanes::rows_of(normal, height));
    }
}

[[gnu::always_inline]] inline Xyz mixed(const SampleBlock& block, std::size_t at, const Corners& c) {
    const Xyz p = lanes::transposed(c.x0), q = lanes::transposed(c.x1), r = lanes::transposed(c.x2);
    const Floats s = load_at(block.shares[0], at), t = load_at(block.shares[1], at), u = load_at(block.shares[2], at);
    return {lanes::multiply_add(p.x, s, lanes::multiply_add(q.x, t, r.x * u)),
            lanes::multiply_add(p.y, s, lanes::multiply_add(q.y, t, r.y * u)),
            lanes::multiply_add(p.z, s, lanes::multiply_add(q.z, t, r.z * u))};
}

[[gnu::always_inline]] inline ContactCache near(const SampleBlock& block, std::size_t at, const Xyz& x) {
    return near(x, load_three(block.query_point, at), load_at(block.slack, at), load_three(block.normal, at),
                load_at(block.height, at));
}

SampleState locate_samples(const SampleBlock& block, const float* points, ContactBlock& at_points) {
    unsigned needs_query = 0, touches = 0;
    for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
        const Xyz x = mixed(block, at, corners_of(block, at, points));
        lanes::store(&at_points.x[at], x.x);
        lanes::store(&at_points.y[at], x.y);
        lanes::store(&at_points.z[at], x.z);
        const ContactCache here = near(block, at, x);
        needs_query |= lanes::bits(here.needs_query);
        touches |= lanes::bits(here.may_touch);
    }
    return {needs_query != 0, touches != 0};
}

void store_query(const ContactBlock& result, const ContactLimits& limits, SampleBlock& block) {
    for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
        const Xyz x = load_xyz(result, at), normal = load_normal(result, at);
        const Floats height = lanes::load(&result.distance[at]) - limits.offset;
        const Ints is_new = load_at(block.slack, at) < ContactCacheArrays::kInvalidBelow;
        lanes::store(&block.sunk[at], lanes::where(is_new, lanes::max(-height, Floats{})));
        store_three(block.query_point, at, x.x, x.y, x.z);
        lanes::store(&block.slack[at], height - limits.margin);
        store_three(block.normal, at, normal.x, normal.y, normal.z);
        lanes::store(&block.height[at], height);
    }
}

// The displacement of each corner that moves the sample by 1: proportional to its weight, and 0 if it cannot move.
struct CornerShares {
    Floats s0, s1, s2;
};
[[gnu::always_inline]] inline CornerShares corner_shares(const SampleBlock& block, std::size_t at, const Corners& c) {
    const auto share = [&](std::size_t i, const Rows& x) {
        return lanes::where(w_of(x) > 0.0F, load_at(block.shares[i], at));
    };
    const Floats s0 = share(0, c.x0), s1 = share(1, c.x1), s2 = share(2, c.x2);
    const Floats sum = lanes::multiply_add(s0, s0, lanes::multiply_add(s1, s1, s2 * s2));
    const Floats scale = lanes::where(sum > 0.0F, 1.0F / lanes::max(sum, lanes::broadcast(kTiny)));
    return {s0 * scale, s1 * scale, s2 * scale};
}
[[gnu::always_inline]] inline Rows shifted(const Rows& x, const Xyz& by, Floats share) {
    const Rows shift = lanes::rows_of({by.x * share, by.y * share, by.z * share});
    Rows moved;
    for (int j = 0; j < 4; ++j) moved.row[j] = x.row[j] + shift.row[j];
    return moved;
}
[[gnu::always_inline]] inline Corners shifted(const Corners& c, const Xyz& by, const CornerShares& shares) {
    return {shifted(c.x0, by, shares.s0), shifted(c.x1, by, shares.s1), shifted(c.x2, by, shares.s2)};
}

// A new sample may start below the offset surface. It did not move there, so it is lifted by that depth without gaining
// velocity.
void push_samples(SampleBlock& block, const ContactLimits& limits, float* points, float* before) {
    for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
        const Corners c = corners_of(block, at, points);
        const Xyz x = mixed(block, at, c);
        const ContactCache here = near(block, at, x);
        const Floats depth = lanes::where(here.may_touch, -here.height);
        if (lanes::bits(depth > 0.0F) == 0) continue;
        const CornerShares shares = corner_shares(block, at, c);
        Corners from = corners_of(block, at, before);
        const Floats sunk = load_at(block.sunk, at);
        if (lanes::bits(sunk > 0.0F) != 0) {
            from = shifted(from, {here.normal.x * sunk, here.normal.y * sunk, here.normal.z * sunk}, shares);
            put_corners(block, at, from, before);
            lanes::store(&block.sunk[at], Floats{});
        }
        const Floats mu = load_at(block.friction, at) * limits.friction_scale;
        const Xyz out = project(x, mixed(block, at, from), here.normal, depth, mu);
        put_corners(block, at, shifted(c, {out.x - x.x, out.y - x.y, out.z - x.z}, shares), points);
    }
}

}  // namespace
}  // namespace selvedge::sim
