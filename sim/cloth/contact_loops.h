#pragma once
// The kernels of contacts, which keep vertices and samples outside of a body, and vertices above the floor; for their
// contracts see kernels.h. Include it only in kernel sources (kernels_simd.cpp; see sim/core/simd_level.h).
#include <algorithm>
#include <limits>

#include "sim/cloth/loop_parts.h"
#include "sim/cloth/projection.h"

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
    Floats squared;    // m^2, of the distance that the point has moved since its query
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
    return {normal, now, is_near & is_lost, is_known, is_known & (now < 0.0F), squared};
}

// The arithmetic of as many points as a register holds; see projection.h.
struct ManyPoints {
    using Real = Floats;
    using Xyz = lanes::Xyz;

    [[gnu::always_inline]] static Floats dot(const Xyz& a, const Xyz& b) { return selvedge::sim::dot(a, b); }
    [[gnu::always_inline]] static Xyz minus(const Xyz& a, const Xyz& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    [[gnu::always_inline]] static Xyz plus(const Xyz& a, const Xyz& b, Floats t) {
        return {a.x + b.x * t, a.y + b.y * t, a.z + b.z * t};
    }
    [[gnu::always_inline]] static Xyz minus(const Xyz& a, const Xyz& b, Floats t) {
        return {a.x - b.x * t, a.y - b.y * t, a.z - b.z * t};
    }
    [[gnu::always_inline]] static Floats share_of(Floats held, Floats squared) {
        return lanes::min(held * lanes::inverse_root(squared + lanes::broadcast(kTiny)), lanes::broadcast(1.0F));
    }
};
using StillPlanes = MetPlane<ManyPoints>;
using MovedPlanes = MetPlane<ManyPoints, Xyz>;

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
    const StillPlanes floor{.normal = up, .depth = lanes::where(below, limits.floor - x.y)};
    const Xyz above = projected(x, before, floor, mu);
    const Xyz lift{above.x - x.x, above.y - x.y, above.z - x.z};
    const Floats height = lanes::min(known.height + dot(known.normal, lift), Floats{});
    const StillPlanes side{.normal = known.normal, .depth = lanes::where(known.is_known, -height)};
    return lanes::rows_of(projected(above, before, side, mu), w_of(was));
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
        Rows moved = lanes::rows_of(projected(x, from, StillPlanes{.normal = normal, .depth = depth}, mu));
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
    return near(x, load_three(block.side.point, at), load_at(block.slack, at), load_three(block.side.normal, at),
                load_at(block.side.height, at));
}

[[gnu::always_inline]] inline float least_of(Floats values) {
    float least = values[0];
    for (std::size_t i = 1; i < lanes::kCount; ++i) least = std::min(least, float(values[i]));
    return least;
}

SampleState locate_samples(const SampleBlock& block, const float* points, ContactBlock& at_points) {
    unsigned to_query = 0, touches = 0;
    BlockFloats squared;
    for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
        const Xyz x = mixed(block, at, corners_of(block, at, points));
        lanes::store(&at_points.x[at], x.x);
        lanes::store(&at_points.y[at], x.y);
        lanes::store(&at_points.z[at], x.z);
        const ContactCache here = near(block, at, x);
        to_query |= lanes::bits(here.needs_query) << at;
        touches |= lanes::bits(here.may_touch);
        lanes::store(&squared[at], here.squared);
    }
    if ((to_query | touches) != 0) return {to_query, touches != 0, 0};
    Floats free = lanes::broadcast(std::numeric_limits<float>::max());
    for (std::size_t at = 0; at < kBlock; at += lanes::kCount)
        free = lanes::min(free, load_at(block.slack, at) - lanes::sqrt(load_at(squared, at)));
    return {0, false, least_of(free)};
}

// a in lanes where the comparison is true, b in the others.
[[gnu::always_inline]] inline Floats chosen(Ints comparison, Floats a, Floats b) {
    return Floats((comparison & Ints(a)) | (~comparison & Ints(b)));
}

void store_query(const ContactBlock& result, const ContactLimits& limits, SampleBlock& block) {
    for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
        const Xyz x = load_xyz(result, at), normal = load_normal(result, at);
        const Floats height = lanes::load(&result.distance[at]) - limits.offset;
        const Ints is_new = load_at(block.slack, at) < ContactCacheArrays::kInvalidBelow;
        lanes::store(&block.sunk[at], lanes::where(is_new, lanes::max(-height, Floats{})));
        store_three(block.side.point, at, x.x, x.y, x.z);
        const Ints is_used = load_at(block.shares[0], at) > 0.0F;
        lanes::store(&block.slack[at], chosen(is_used, height - limits.margin, load_at(block.slack, at)));
        store_three(block.side.normal, at, normal.x, normal.y, normal.z);
        lanes::store(&block.side.height[at], height);
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

// A group of kCount samples of a block, from slot `at` on.
struct LocatedSamples {
    Corners corners;
    Xyz x;
    ContactCache cache;
};
[[gnu::always_inline]] inline LocatedSamples located(const SampleBlock& block, std::size_t at, const float* points) {
    const Corners c = corners_of(block, at, points);
    const Xyz x = mixed(block, at, c);
    return {c, x, near(block, at, x)};
}

// The corners of samples that are `depth` below the offset surface, after their projection, and one sub-step ago.
struct PushedCorners {
    Corners now, before;
};
// A new sample may start below the offset surface, by `sunk`. It did not move there, so it is lifted by that depth
// without gaining velocity.
[[gnu::always_inline]] inline PushedCorners pushed(const SampleBlock& block, std::size_t at, const LocatedSamples& s,
                                                   Floats depth, Floats sunk, float friction_scale,
                                                   const float* before) {
    const CornerShares shares = corner_shares(block, at, s.corners);
    const Xyz& normal = s.cache.normal;
    Corners from = corners_of(block, at, before);
    if (lanes::bits(sunk > 0.0F) != 0)
        from = shifted(from, {normal.x * sunk, normal.y * sunk, normal.z * sunk}, shares);
    const Floats mu = load_at(block.friction, at) * friction_scale;
    const StillPlanes side{.normal = normal, .depth = depth, .gained = lanes::min(sunk, depth)};
    const Xyz out = projected(s.x, mixed(block, at, from), side, mu);
    return {shifted(s.corners, {out.x - s.x.x, out.y - s.x.y, out.z - s.x.z}, shares), from};
}

void push_samples(SampleBlock& block, const ContactLimits& limits, float* points, float* before) {
    for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
        const LocatedSamples s = located(block, at, points);
        const Floats depth = lanes::where(s.cache.may_touch, -s.cache.height);
        if (lanes::bits(depth > 0.0F) == 0) continue;
        const Floats sunk = load_at(block.sunk, at);
        const PushedCorners to = pushed(block, at, s, depth, sunk, limits.friction_scale, before);
        if (lanes::bits(sunk > 0.0F) != 0) {
            put_corners(block, at, to.before, before);
            lanes::store(&block.sunk[at], Floats{});
        }
        put_corners(block, at, to.now, points);
    }
}

// Stores the corners of one lane alone.
[[gnu::always_inline]] inline void put_lane(const SampleBlock& block, std::size_t at, std::size_t lane,
                                            const Corners& c, float* points) {
    const auto put = [&](std::size_t k, const Rows& x) {
        float rows[4 * lanes::kCount];
        for (std::size_t j = 0; j < 4; ++j) lanes::store(rows + j * lanes::kCount, x.row[j]);
        std::memcpy(points + block.vertices[k][at + lane], rows + lane % 4 * lanes::kCount + lane / 4 * 4,
                    4 * sizeof(float));
    };
    put(0, c.x0);
    put(1, c.x1);
    put(2, c.x2);
}

// The lanes after `lane`, and the lanes of the group at `at` from slot `first` on, one bit each.
constexpr unsigned lanes_after(std::size_t lane) {
    return ~0U << (lane + 1);
}
constexpr unsigned lanes_from(std::size_t first, std::size_t at) {
    if (first >= at + lanes::kCount) return 0;
    return first > at ? ~0U << (first - at) : ~0U;
}

std::size_t push_samples_in_turn(SampleBlock& block, std::size_t first, const ContactLimits& limits, float* points,
                                 float* before) {
    for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
        unsigned rest = lanes_from(first, at);
        while (rest != 0) {
            const LocatedSamples s = located(block, at, points);
            const unsigned to_query = lanes::bits(s.cache.needs_query) & rest;
            const unsigned met = to_query | (lanes::bits(s.cache.may_touch) & rest);
            if (met == 0) break;
            const auto lane = static_cast<std::size_t>(__builtin_ctz(met));
            if ((to_query >> lane & 1U) != 0) return at + lane;
            const PushedCorners to = pushed(block, at, s, lanes::where(s.cache.may_touch, -s.cache.height),
                                            load_at(block.sunk, at), limits.friction_scale, before);
            if (block.sunk[at + lane] > 0) {
                put_lane(block, at, lane, to.before, before);
                block.sunk[at + lane] = 0;
            }
            put_lane(block, at, lane, to.now, points);
            rest &= lanes_after(lane);
        }
    }
    return kBlock;
}

float longest_motion(const float* points, float* last, std::size_t count) {
    Floats longest{};
    for (std::size_t i = 0; i < 4 * count; i += lanes::kCount) {
        const Floats x = lanes::load(points + i);
        const Floats move = lanes::with_w_components(x - lanes::load(last + i), Floats{});
        lanes::store(last + i, x);
        longest = lanes::max(longest, squared_lengths(move));
    }
    return -least_of(-lanes::sqrt(longest));
}

}  // namespace
}  // namespace selvedge::sim
