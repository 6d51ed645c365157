#pragma once
// The kernels that measure pairs, solve contacts and test dividing planes; for their contracts see kernels.h. Include
// it only in kernel sources (kernels_simd.cpp; see sim/core/simd_level.h).
#include "sim/selfcontact/search_loops.h"

namespace selvedge::sim {
namespace {

constexpr float kTinySquare = 1e-20F;  // m^2, lower bound of divisors

[[gnu::always_inline]] inline Floats either(Ints comparison, Floats a, Floats b) {
    return Floats((comparison & Ints(a)) | (~comparison & Ints(b)));
}
[[gnu::always_inline]] inline Floats load_row(const BlockFloats& row, std::size_t at) {
    return lanes::load(&row[at]);
}
[[gnu::always_inline]] inline void store_row(BlockFloats& row, std::size_t at, Floats values) {
    lanes::store(&row[at], values);
}
[[gnu::always_inline]] inline Xyz load_rows(const std::array<BlockFloats, 3>& rows, std::size_t at) {
    return {load_row(rows[0], at), load_row(rows[1], at), load_row(rows[2], at)};
}
[[gnu::always_inline]] inline void store_rows(std::array<BlockFloats, 3>& rows, std::size_t at, const Xyz& p) {
    store_row(rows[0], at, p.x);
    store_row(rows[1], at, p.y);
    store_row(rows[2], at, p.z);
}

struct Four {
    Xyz p[4];
};
// Of a PairBlock or a SelfContactBlock.
template <class Block>
[[gnu::always_inline]] inline Four vertices_of(const Block& block, std::size_t at, const float* points) {
    return {{points_at(points, &block.vertices[0][at]), points_at(points, &block.vertices[1][at]),
             points_at(points, &block.vertices[2][at]), points_at(points, &block.vertices[3][at])}};
}

struct Weights {
    Floats w[4];
    Ints is_inner;  // both closest points are inside of their triangle or edge
};

// The vector between the closest points, from the second side to the first.
[[gnu::always_inline]] inline Xyz weighted(const Weights& weights, const Four& x) {
    Xyz sum{x.p[0].x * weights.w[0], x.p[0].y * weights.w[0], x.p[0].z * weights.w[0]};
    for (int k = 1; k < 4; ++k) sum = plus(sum, weights.w[k], x.p[k]);
    return sum;
}

// Squared distance from the origin to the segment from a along d; and where: 0 at a, 1 at its end.
struct OnSegment {
    Floats squared, t;
};
[[gnu::always_inline]] inline OnSegment nearest_on_segment(const Xyz& a, const Xyz& d) {
    const Floats length = lanes::max(dot(d, d), lanes::broadcast(kTinySquare));
    const Floats t = lanes::clamp_to_unit(-dot(a, d) / length);
    const Xyz at = plus(a, t, d);
    return {dot(at, at), t};
}

// The closest point of triangle bce to a point p: inside, or else on the nearest of its edges.
[[gnu::always_inline]] inline Weights nearest_on_triangle(const Four& x) {
    const Xyz b = minus(x.p[1], x.p[0]), c = minus(x.p[2], x.p[0]), e = minus(x.p[3], x.p[0]);
    const Xyz bc = minus(c, b), ce = minus(e, c), eb = minus(b, e);
    const Xyz normal = cross(bc, minus(e, b));
    // areas of the triangles opposite to each corner, projected onto the plane, times twice the area
    const Floats of_b = dot(cross(ce, minus(Xyz{}, c)), normal);
    const Floats of_c = dot(cross(eb, minus(Xyz{}, e)), normal);
    const Floats of_e = dot(cross(bc, minus(Xyz{}, b)), normal);
    const Ints is_inner = (of_b > 0.0F) & (of_c > 0.0F) & (of_e > 0.0F);
    const Floats inverse = 1.0F / lanes::max(of_b + of_c + of_e, lanes::broadcast(kTinySquare * kTinySquare));

    const OnSegment first = nearest_on_segment(b, bc), second = nearest_on_segment(c, ce),
                    third = nearest_on_segment(e, eb);
    const Ints is_second = second.squared < first.squared;
    const Ints is_third = third.squared < lanes::min(first.squared, second.squared);
    const Floats zero{}, one = lanes::broadcast(1.0F);
    Floats wb = either(is_second, zero, one - first.t), wc = either(is_second, one - second.t, first.t),
           we = either(is_second, second.t, zero);
    wb = either(is_third, third.t, wb);
    wc = either(is_third, zero, wc);
    we = either(is_third, one - third.t, we);
    wb = either(is_inner, of_b * inverse, wb);
    wc = either(is_inner, of_c * inverse, wc);
    we = either(is_inner, of_e * inverse, we);
    return {{one, -wb, -wc, -we}, is_inner};
}

// The closest points of two segments.  (Ericson, Real-Time Collision Detection, 5.1.9)
[[gnu::always_inline]] inline Weights nearest_on_edges(const Four& x) {
    constexpr float kParallel = 1e-6F;  // squared sine of the angle below which any point is as near
    const Xyz d = minus(x.p[1], x.p[0]), e = minus(x.p[3], x.p[2]), r = minus(x.p[0], x.p[2]);
    const Floats dd = lanes::max(dot(d, d), lanes::broadcast(kTinySquare));
    const Floats ee = lanes::max(dot(e, e), lanes::broadcast(kTinySquare));
    const Floats de = dot(d, e), dr = dot(d, r), er = dot(e, r);
    const Floats determinant = dd * ee - de * de;
    const Ints crosses = determinant > kParallel * dd * ee;
    const Floats free = (de * er - dr * ee) / lanes::max(determinant, lanes::broadcast(kTinySquare * kTinySquare));
    Floats s = either(crosses, lanes::clamp_to_unit(free), lanes::broadcast(0.5F));
    const Floats t = lanes::clamp_to_unit((de * s + er) / ee);
    s = lanes::clamp_to_unit((de * t - dr) / dd);
    const Floats one = lanes::broadcast(1.0F);
    return {{one - s, s, t - one, -t}, (s > 0.0F) & (s < 1.0F) & (t > 0.0F) & (t < 1.0F)};
}

template <PairKind kind>
[[gnu::always_inline]] inline Weights nearest(const Four& x) {
    if constexpr (kind == PairKind::VertexTriangle) {
        return nearest_on_triangle(x);
    } else {
        return nearest_on_edges(x);
    }
}

// The least value of the first side and the greatest of the second, of n times each vertex's vector.
struct Extents {
    Floats first, second;
};
template <PairKind kind>
[[gnu::always_inline]] inline Extents extents(const Xyz& n, const Four& x) {
    const Floats a = dot(n, x.p[0]), b = dot(n, x.p[1]), c = dot(n, x.p[2]), d = dot(n, x.p[3]);
    if constexpr (kind == PairKind::VertexTriangle) {
        return {a, lanes::max(b, lanes::max(c, d))};
    } else {
        return {lanes::min(a, b), lanes::max(c, d)};
    }
}

constexpr float kTouching = 1e-8F;  // m: nearer sides have no direction between them

template <PairKind kind>
[[gnu::always_inline]] inline unsigned measure_lanes(PairBlock& block, std::size_t at, const float* points,
                                                     const Sweep& sweep, const PairReach& reach) {
    const Four x = vertices_of(block, at, points);
    const Weights weights = nearest<kind>(x);
    const Xyz between = weighted(weights, x);
    const Floats distance = lanes::sqrt(dot(between, between));
    const Floats inverse = 1.0F / lanes::max(distance, lanes::broadcast(kTouching));
    const Xyz n{between.x * inverse, between.y * inverse, between.z * inverse};
    const Extents speeds = extents<kind>(n, vertices_of(block, at, sweep.moves));
    const Floats approach = lanes::max(speeds.second - speeds.first, Floats{}) * sweep.substeps;
    const Floats far = lanes::max(load_row(block.radius, at) + reach.margin + approach, lanes::broadcast(reach.least));
    for (std::size_t k = 0; k < 4; ++k) store_row(block.weight[k], at, weights.w[k]);
    store_rows(block.divider, at, n);
    store_rows(block.normal, at, n);
    store_row(block.gap, at, distance);
    return lanes::bits((distance <= far) & (distance > kTouching)) << at;
}

template <PairKind kind>
[[gnu::always_inline]] inline unsigned measure(PairBlock& block, const float* points, const Sweep& sweep,
                                               const PairReach& reach) {
    unsigned found = 0;
    for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
        found |= measure_lanes<kind>(block, at, points, sweep, reach);
    }
    return found;
}

unsigned measure_pairs(PairKind kind, PairBlock& block, const float* points, const Sweep& sweep,
                       const PairReach& reach) {
    return kind == PairKind::VertexTriangle ? measure<PairKind::VertexTriangle>(block, points, sweep, reach)
                                            : measure<PairKind::EdgeEdge>(block, points, sweep, reach);
}

template <class Block>
[[gnu::always_inline]] inline Weights last_weights(const Block& block, std::size_t at) {
    return {{load_row(block.weight[0], at), load_row(block.weight[1], at), load_row(block.weight[2], at),
             load_row(block.weight[3], at)},
            Ints{}};
}

// If the closest points are inner ones and the normal turned round, the sides went through each other: the normal keeps
// its old side. Two edges with other closest points are left to the pairs of a vertex and a triangle that have the same
// ones.
template <PairKind kind>
[[gnu::always_inline]] inline unsigned refresh_lanes(PairBlock& block, std::size_t at, const float* points,
                                                     const float* before, float margin, float substeps) {
    const Four x = vertices_of(block, at, points), was = vertices_of(block, at, before);
    Xyz n = load_rows(block.normal, at);
    const Floats side = load_row(block.side, at), radius = load_row(block.radius, at);
    const auto touches = [&](const Floats& distance, const Weights& weights, const Xyz& normal, float near) {
        const Floats speed = side * (dot(normal, weighted(weights, x)) - dot(normal, weighted(weights, was)));
        return (side * distance + lanes::min(speed, Floats{}) * substeps <= radius + near) & (side != 0.0F);
    };
    const Weights last = last_weights(block, at);
    if (lanes::bits(touches(dot(n, weighted(last, x)), last, n, 0.75F * margin)) == 0) return 0;
    const Weights weights = nearest<kind>(x);
    const Xyz between = weighted(weights, x);
    Floats distance = lanes::sqrt(dot(between, between));
    const Floats inverse = 1.0F / lanes::max(distance, lanes::broadcast(kTouching));
    const Xyz now{between.x * inverse, between.y * inverse, between.z * inverse};
    const Floats turned =
        either(weights.is_inner & (dot(now, n) < 0.0F), lanes::broadcast(-1.0F), lanes::broadcast(1.0F));
    const Ints is_known = distance > kTouching;
    n = {either(is_known, now.x * turned, n.x), either(is_known, now.y * turned, n.y),
         either(is_known, now.z * turned, n.z)};
    distance *= turned;
    for (std::size_t k = 0; k < 4; ++k) store_row(block.weight[k], at, weights.w[k]);
    store_rows(block.normal, at, n);
    Ints listed = touches(distance, weights, n, 0.25F * margin);
    if constexpr (kind == PairKind::EdgeEdge) listed &= weights.is_inner;
    return lanes::bits(listed) << at;
}

template <PairKind kind>
[[gnu::always_inline]] inline unsigned refresh(PairBlock& block, const float* points, const float* before, float margin,
                                               float substeps) {
    unsigned found = 0;
    for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
        found |= refresh_lanes<kind>(block, at, points, before, margin, substeps);
    }
    return found;
}

unsigned refresh_pairs(PairKind kind, PairBlock& block, const float* points, const float* before, float margin,
                       float substeps) {
    return kind == PairKind::VertexTriangle ? refresh<PairKind::VertexTriangle>(block, points, before, margin, substeps)
                                            : refresh<PairKind::EdgeEdge>(block, points, before, margin, substeps);
}

template <PairKind kind>
[[gnu::always_inline]] inline unsigned undivided(const PairBlock& block, const float* points, float gap_share,
                                                 float radius_share, float& least_slack) {
    constexpr float kFar = 1e6F;  // m
    unsigned found = 0;
    Floats least = lanes::broadcast(kFar);
    for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
        Four x = vertices_of(block, at, points);
        for (int k = 3; k >= 0; --k) x.p[k] = minus(x.p[k], x.p[0]);  // so that little is lost to rounding
        const Extents sides = extents<kind>(load_rows(block.divider, at), x);
        const Floats asked = lanes::min(gap_share * load_row(block.gap, at), radius_share * load_row(block.radius, at));
        const Floats slack = sides.first - sides.second - asked;
        const Ints is_known = load_row(block.side, at) > 0.0F;
        found |= lanes::bits((slack < 0.0F) & is_known) << at;
        least = lanes::min(least, either(is_known, slack, lanes::broadcast(kFar)));
    }
    least_slack = least[0];
    for (std::size_t k = 1; k < lanes::kCount; ++k) least_slack = least[k] < least_slack ? least[k] : least_slack;
    return found;
}

unsigned find_undivided(PairKind kind, const PairBlock& block, const float* points, float gap_share, float radius_share,
                        float& least_slack) {
    return kind == PairKind::VertexTriangle
               ? undivided<PairKind::VertexTriangle>(block, points, gap_share, radius_share, least_slack)
               : undivided<PairKind::EdgeEdge>(block, points, gap_share, radius_share, least_slack);
}

// A bit for each contact whose sides are nearer than its radius.
[[gnu::always_inline]] inline unsigned too_near(const SelfContactBlock& block, const float* points) {
    unsigned found = 0;
    for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
        const Xyz between = weighted(last_weights(block, at), vertices_of(block, at, points));
        found |= lanes::bits(dot(load_rows(block.normal, at), between) < load_row(block.radius, at)) << at;
    }
    return found;
}

// The acting ones one at a time: four floats per vertex.

using Point [[gnu::vector_size(16)]] = float;

[[gnu::always_inline]] inline Point load_point(const float* from) {
    Point p;
    std::memcpy(&p, from, sizeof p);
    return p;
}
[[gnu::always_inline]] inline void store_point(float* to, Point p) {
    std::memcpy(to, &p, sizeof p);
}
[[gnu::always_inline]] inline float dot3(Point a, Point b) {
    const Point product = a * b;
    return product[0] + product[1] + product[2];
}

// The sum of the weighted vertices of a contact; its w is meaningless.
[[gnu::always_inline]] inline Point weighted_sum(const SelfContactBlock& block, std::size_t at, const float* points) {
    Point sum = load_point(points + block.vertices[0][at]) * block.weight[0][at];
    for (std::size_t k = 1; k < 4; ++k) sum += load_point(points + block.vertices[k][at]) * block.weight[k][at];
    return sum;
}

[[gnu::always_inline]] inline bool solve_contact(const SelfContactBlock& block, std::size_t at, float* points,
                                                 float* before) {
    const Point normal{block.normal[0][at], block.normal[1][at], block.normal[2][at], 0};
    const Point now = weighted_sum(block, at, points);
    const float depth = block.radius[at] - dot3(now, normal);
    if (depth <= 0) return false;
    const Point moved = now - weighted_sum(block, at, before);
    const float along = dot3(moved, normal);
    const float stop = along < 0 ? (-along < depth ? -along : depth) : 0;
    const float longest = block.longest_push[at];
    const float push = depth - stop < longest ? depth - stop : longest;
    const Point slid = moved - normal * along;
    const float slid_squared = dot3(slid, slid);
    const float grip = block.friction[at] * stop;
    const float taken = slid_squared <= grip * grip ? 1.0F : grip / __builtin_sqrtf(slid_squared);
    const Point move = (normal * (stop + push) - slid * taken) * block.inverse[at];
    const Point back = normal * (push * block.inverse[at]);
    for (std::size_t k = 0; k < 4; ++k) {
        float* const x = points + block.vertices[k][at];
        float* const was = before + block.vertices[k][at];
        const Point p = load_point(x);
        const float share = block.weight[k][at] * p[3];
        Point to = p + move * share;
        to[3] = p[3];
        store_point(x, to);
        store_point(was, load_point(was) + back * share);  // back has a w of 0
    }
    return true;
}

std::size_t solve_contacts(std::span<const SelfContactBlock> blocks, float* points, float* before) {
    std::size_t acted = 0;
    for (const SelfContactBlock& block : blocks) {
        for (unsigned found = too_near(block, points); found != 0; found &= found - 1) {
            const auto at = static_cast<std::size_t>(__builtin_ctz(found));
            acted += solve_contact(block, at, points, before) ? 1U : 0U;
        }
    }
    return acted;
}

}  // namespace
}  // namespace selvedge::sim
