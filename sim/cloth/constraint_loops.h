#pragma once
// The kernels of stretch and shear of leaves, of the coarse strain limits, of the updates of biases and gains, and of
// prediction and internal damping; for their contracts see kernels.h. Include it only in kernel sources
// (kernels_simd.cpp; see sim/core/simd_level.h).
#include "sim/cloth/loop_parts.h"

namespace selvedge::sim {

// Sums of stress between levels, and the update of the biases of the coarse strain limits.

namespace {

// Entries of LevelStress are read and written as points are. The inner triangles of one parent share vertices
// pairwise, so within a colour no two have the same parent entry. The entry of "no triangle" may occur several times;
// it is never written.
[[gnu::always_inline]] inline Xyz load_stress(const float* stress, const std::uint32_t* offsets) {
    return lanes::transposed(lanes::gather_points(stress, offsets));
}
[[gnu::always_inline]] inline bool are_all_of_triangles(const std::uint32_t* offsets) {
    return lanes::bits(lanes::load_ints(offsets) == static_cast<std::int32_t>(kNoOffset)) == 0;
}
[[gnu::always_inline]] inline void store_rows(float* stress, const std::uint32_t* offsets, const Rows& rows) {
    if (are_all_of_triangles(offsets)) return lanes::scatter_points(stress, offsets, rows);
    for (std::size_t i = 0; i < lanes::kCount; ++i) {
        if (offsets[i] == kNoOffset) continue;
        for (std::size_t k = 0; k < 4; ++k) stress[offsets[i] + k] = rows.row[i % 4][4 * (i / 4) + k];
    }
}
[[gnu::always_inline]] inline void store_stress(float* stress, const std::uint32_t* offsets, const Xyz& values) {
    store_rows(stress, offsets, lanes::rows_of(values));
}
[[gnu::always_inline]] inline void add_stress(float* stress, const std::uint32_t* offsets, const Xyz& by) {
    Rows sum = lanes::gather_points(stress, offsets);
    const Rows more = lanes::rows_of(by);
    for (int j = 0; j < 4; ++j) sum.row[j] = sum.row[j] + more.row[j];
    store_rows(stress, offsets, sum);
}
[[gnu::always_inline]] inline Xyz sum_of(const Xyz& p, const Xyz& q) {
    return {p.x + q.x, p.y + q.y, p.z + q.z};
}

// The stress of warp, weft and shear that the triangle itself bears, divided by stiffness.
template <class Record>
[[gnu::always_inline]] inline Xyz stress_of(const Record& record, std::size_t at) {
    const auto one = [&](std::size_t k) {
        return -load_at(record.multiplier[k], at) * load_at(record.compliance[k], at);
    };
    return {one(0), one(1), one(2)};
}

void prolong_stress(std::span<const LimitRecord> records, float* above) {
    for (const LimitRecord& record : records) {
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            const Xyz all = sum_of(load_stress(above, &record.parent[at]), stress_of(record, at));
            store_stress(above, &record.offset[at], all);
        }
    }
}

// Sets the maximum lengths and the shear multiplier of a coarse strain limit from its biases.
[[gnu::always_inline]] inline void apply_bias(LimitBlock& block, const LimitRecord& record, std::size_t at) {
    lanes::store(&block.longest_warp[at], load_at(record.free_length[0], at) - load_at(record.bias[0], at));
    lanes::store(&block.longest_weft[at], load_at(record.free_length[1], at) - load_at(record.bias[1], at));
    lanes::store(&block.shear[at], load_at(record.bias[2], at) * -load_at(record.per_shear, at));
}

// Returns the sum at the triangle's entry and clears it; adds the sum and `more`, weighted by area, to the parent's
// entry.
[[gnu::always_inline]] inline Xyz take_sum(float* sums, const LimitRecord& record, std::size_t at, const Xyz& more) {
    const Xyz inside = load_stress(sums, &record.offset[at]);
    store_stress(sums, &record.offset[at], Xyz{});
    const Xyz here = sum_of(inside, more);
    const Floats of_area = load_at(record.of_area, at);
    add_stress(sums, &record.parent[at], {here.x * of_area, here.y * of_area, here.z * of_area});
    return inside;
}

// The stress of warp, weft and shear in a refined triangle, divided by stiffness: what it bears itself; what it and its
// ancestors bear; and the sum of these and of what its inner triangles bear.
struct Stress {
    Xyz own, coarse, all;

    // The tension of warp and weft together, N/m up to a constant factor.
    static Floats tension(const LimitRecord& record, std::size_t at, const Xyz& stress) {
        const Floats sum = stress.x / load_at(record.compliance[0], at) + stress.y / load_at(record.compliance[1], at);
        return lanes::max(sum, lanes::broadcast(kTiny));
    }
};

// off: the mean strain error of its leaves. The strain of the refined triangle itself is not suitable: the flat
// triangle through the corners of bent cloth is shorter than the cloth in some directions and longer in others.
//
// Tension along the yarns alone may come from refined triangles or from leaves. If it occurs together with shear, the
// shares matter: forces of coarse triangles act on all vertices that follow their corners, so at the edges of the cloth
// they balance only if tension and shear have the same ratio as in the total stress. So the tension bias of a refined
// triangle stops growing once it and its ancestors bear what the leaves cannot bear well: leaves bear some shear well
// (LimitRecord::bearable_shear), and keep the tension that goes with it. Without this bound the levels together would
// bear more than the total stress, and their leaves would push against them. And a refined triangle bears the same
// share of shear as of tension.
[[gnu::always_inline]] inline void move_biases(LimitRecord& record, std::size_t at, const Stress& stress,
                                               const Xyz& off, const BiasGains& gains) {
    const Floats one = lanes::broadcast(1.0F);
    const Floats tension = Stress::tension(record, at, stress.all);
    const Floats coarse = Stress::tension(record, at, stress.coarse) / tension;
    const Floats per_tension = lanes::broadcast(2.0F) / (load_at(record.compliance[2], at) * tension);
    const Floats sheared = lanes::max(stress.all.z, -stress.all.z);
    const Floats share_of_leaves =
        lanes::min(lanes::min(sheared, load_at(record.bearable_shear, at)) * per_tension, one);
    const auto move = [&](std::size_t k, Floats by) {
        const Floats allowed = lanes::where(coarse < one - share_of_leaves, by) +
                               lanes::where(coarse >= one - share_of_leaves, lanes::min(by, Floats{}));
        move_bias(record.bias[k], at, allowed, gains.stretch, Floats{}, gains.most);
    };
    move(0, off.x);
    move(1, off.y);
    const Floats share = lanes::min(Stress::tension(record, at, stress.own) / tension, one);
    const Floats missing = share * stress.all.z - stress.own.z;
    move_bias(record.bias[2], at, missing * load_at(record.per_stress[2], at), gains.stretch,
              lanes::broadcast(-kMoreShear * gains.most), kMoreShear * gains.most);
}

void update_limit_biases(std::span<LimitBlock> blocks, std::span<LimitRecord> records, const BiasGains& gains,
                         const StressSums& sums) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        LimitRecord& record = records[i];
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            const Xyz own = stress_of(record, at);
            const Xyz coarse = load_stress(sums.above, &record.offset[at]);
            const Xyz all = sum_of(take_sum(sums.below, record, at, own), coarse);
            const Xyz off = take_sum(sums.off, record, at, Xyz{});
            move_biases(record, at, {.own = own, .coarse = coarse, .all = all}, off, gains);
            apply_bias(blocks[i], record, at);
        }
    }
}

struct Strains {
    Floats warp, weft, shear;
};

// The shear strain; and the strain that friction between the yarns adds, whose anchor is updated.
[[gnu::always_inline]] inline Floats shear_of(const YarnDirections& t) {
    return dot(t.warp, t.weft) * t.warp_arm * t.weft_arm;
}
[[gnu::always_inline]] inline Floats friction_shear(StretchBlock& block, std::size_t at, Floats shear) {
    const Floats off = clamped(shear - load_at(block.anchor, at), load_at(block.slip, at));
    lanes::store(&block.anchor[at], shear - off);
    return off * load_at(block.stick, at);
}

[[gnu::always_inline]] inline Strains biased_strains(const StretchBlock& block, std::size_t at,
                                                     const YarnDirections& t) {
    return {t.warp_length - 1.0F + load_at(block.bias[0], at), t.weft_length - 1.0F + load_at(block.bias[1], at),
            shear_of(t) + load_at(block.bias[2], at)};
}

// Gains: multiplier per strain of each condition.
using Gains = Strains;
[[gnu::always_inline]] inline Gains gains_of(const StretchBlock& block, std::size_t at) {
    return {load_at(block.warp, at), load_at(block.weft, at), load_at(block.shear, at)};
}

// In gathered cloth, slack yarns bear no stress; they are left out of the coupled solve for shear.
[[gnu::always_inline]] inline Gains without_slack(const StretchBlock& block, std::size_t at, const Strains& strain,
                                                  const Gains& gains) {
    const Ints gives = load_at(block.push, at) <= 0.0F;
    const Floats warp = lanes::where(gives & (strain.warp < 0.0F), gains.warp);
    const Floats weft = lanes::where(gives & (strain.weft < 0.0F), gains.weft);
    const Floats cross = load_at(block.cross, at);
    const Floats more = gains.shear * cross * cross * (warp + weft);
    return {gains.warp - warp, gains.weft - weft, gains.shear / (more + 1.0F)};
}

// Solves the three conditions of each triangle together. Warp and weft are orthogonal, so only shear is coupled with
// each of them.
[[gnu::always_inline]] inline Strains multipliers(const StretchBlock& block, std::size_t at, const Strains& strain,
                                                  const Gains& gains) {
    const Floats cross = load_at(block.cross, at);
    const Floats both = lanes::multiply_add(strain.warp, gains.warp, strain.weft * gains.weft);
    const Floats shear = lanes::multiply_add(cross, both, -strain.shear) * gains.shear;
    return {-lanes::multiply_add(cross, shear, strain.warp) * gains.warp,
            -lanes::multiply_add(cross, shear, strain.weft) * gains.weft, shear};
}

[[gnu::always_inline]] inline Strains relaxed(const Strains& m) {
    const Floats share = lanes::broadcast(kLeafShare);
    return {m.warp * share, m.weft * share, m.shear * share};
}

template <class Block>
[[gnu::always_inline]] inline Corners corrected(const Block& block, std::size_t at, const Corners& c,
                                                const YarnDirections& t, const Strains& m) {
    const Floats along_warp = m.shear * t.warp_arm;
    const Floats along_weft = m.shear * t.weft_arm;
    const auto force = [&](std::size_t i) {
        const Floats a = load_at(block.a[i], at), b = load_at(block.b[i], at);
        return lanes::rows_of(combined(t.warp, lanes::multiply_add(m.warp, a, along_warp * b), t.weft,
                                       lanes::multiply_add(m.weft, b, along_weft * a)));
    };
    const Rows f1 = force(0);
    const Rows f2 = force(1);
    const Rows f0 = difference(difference({}, f1), f2);
    return {pushed(c.x0, f0), pushed(c.x1, f1), pushed(c.x2, f2)};
}

// Collects copies of the lanes beyond the fabric's strain limit, without gaps.
struct OverLanes {
    OverBlock* blocks;
    const OverBlock& dummy;
    std::size_t count = 0;

    void add(const StretchBlock& from, std::size_t at) {
        OverBlock& to = blocks[count / kBlock];
        const std::size_t into = count++ % kBlock;
        if (into == 0) to = dummy;
        for (std::size_t k = 0; k < 3; ++k) to.vertices[k][into] = from.vertices[k][at];
        for (std::size_t k = 0; k < 2; ++k) {
            to.a[k][into] = from.a[k][at];
            to.b[k][into] = from.b[k][at];
        }
        to.warp[into] = from.warp[at];
        to.weft[into] = from.weft[at];
        to.longest[into] = from.longest[at];
    }
};

template <bool keeps_multipliers>
[[gnu::always_inline]] inline std::size_t stretch_loop(std::span<StretchBlock> blocks, StretchRecord* records,
                                                       float* points, OverLanes over) {
    for (StretchBlock& block : blocks) {
        const bool has_friction = has_positive(block.stick);
        const bool gives = has_lane(block.push, [](Floats push) { return push <= 0.0F; });
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            const Corners c = corners_of(block, at, points);
            YarnDirections t = directions(block, at, c.x0, c.x1, c.x2);
            normalise(t);
            Strains strains = biased_strains(block, at, t);
            if (has_friction) strains.shear = strains.shear + friction_shear(block, at, shear_of(t));
            Gains gains = gains_of(block, at);
            if (gives) gains = without_slack(block, at, strains, gains);
            const Strains m = relaxed(multipliers(block, at, strains, gains));
            if constexpr (keeps_multipliers) {
                store_three(records[&block - blocks.data()].multiplier, at, m.warp, m.weft, m.shear);
            }
            put_corners(block, at, corrected(block, at, c, t, m), points);
            unsigned found = lanes::bits(lanes::max(t.warp_length, t.weft_length) > load_at(block.longest, at));
            for (; found != 0; found &= found - 1) {
                over.add(block, at + static_cast<std::size_t>(__builtin_ctz(found)));
            }
        }
    }
    return (over.count + kBlock - 1) / kBlock;
}

std::size_t solve_stretch(std::span<StretchBlock> blocks, StretchRecord* records, float* points, OverBlock* over,
                          const OverBlock& dummy) {
    return records ? stretch_loop<true>(blocks, records, points, {over, dummy})
                   : stretch_loop<false>(blocks, nullptr, points, {over, dummy});
}

// Corrects only the excess of warp and weft over the fabric's strain limit.
void limit_stretch(std::span<const OverBlock> blocks, float* points) {
    for (const OverBlock& block : blocks) {
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            const Corners c = corners_of(block, at, points);
            YarnDirections t = directions(block, at, c.x0, c.x1, c.x2);
            normalise(t);
            const Floats longest = load_at(block.longest, at);
            const Strains back{lanes::min(longest - t.warp_length, Floats{}) * load_at(block.warp, at),
                               lanes::min(longest - t.weft_length, Floats{}) * load_at(block.weft, at), Floats{}};
            if (lanes::bits(lanes::min(back.warp, back.weft) < 0.0F) == 0) continue;
            put_corners(block, at, corrected(block, at, c, t, back), points);
        }
    }
}

// For one yarn direction of refined triangles: the necessary change of length, relative to its length; at most 0.
[[gnu::always_inline]] inline Floats excess(const Xyz& direction, Floats longest) {
    const Floats squared = dot(direction, direction) + lanes::broadcast(kTiny);
    return lanes::min(longest * lanes::inverse_root(squared) - 1.0F, Floats{});
}

template <bool keeps_multipliers>
[[gnu::always_inline]] inline void limit_loop(std::span<const LimitBlock> blocks, LimitRecord* records, float* points) {
    for (const LimitBlock& block : blocks) {
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            Corners c = corners_of(block, at, points);
            const YarnDirections t = directions(block, at, c.x0, c.x1, c.x2);
            const Floats warp = excess(t.warp, load_at(block.longest_warp, at));
            const Floats weft = excess(t.weft, load_at(block.longest_weft, at));
            const Floats of_warp = warp * load_at(block.gain[0], at);
            const Floats of_weft = weft * load_at(block.gain[1], at);
            // With this bound the stress has no compressive principal component.
            const Floats shear = clamped(load_at(block.shear, at), lanes::sqrt(of_warp * of_weft));
            if constexpr (keeps_multipliers) {
                store_three(records[&block - blocks.data()].multiplier, at, of_warp, of_weft, shear);
            }
            if (lanes::bits(lanes::min(warp, weft) < 0.0F) == 0) continue;
            const auto add = [&](Rows& x, std::size_t i) {
                const Floats a = load_at(block.warp[i], at), b = load_at(block.weft[i], at);
                const Rows by = lanes::rows_of(combined(t.warp, lanes::multiply_add(of_warp, a, shear * b), t.weft,
                                                        lanes::multiply_add(of_weft, b, shear * a)));
                for (int j = 0; j < 4; ++j) x.row[j] = x.row[j] + by.row[j];
            };
            add(c.x0, 0);
            add(c.x1, 1);
            add(c.x2, 2);
            put_corners(block, at, c, points);
        }
    }
}

void solve_coarse_limits(std::span<const LimitBlock> blocks, LimitRecord* records, float* points) {
    records ? limit_loop<true>(blocks, records, points) : limit_loop<false>(blocks, nullptr, points);
}

// The gradients -(g0 + g1), g0 and g1 of a yarn direction at the three corners; and the sum of w f g over the corners.
using Gradient = std::array<Floats, 3>;
[[gnu::always_inline]] inline Gradient gradient(const std::array<BlockFloats, 2>& g, std::size_t at) {
    const Floats g0 = load_at(g[0], at), g1 = load_at(g[1], at);
    return {-(g0 + g1), g0, g1};
}
[[gnu::always_inline]] inline Floats dot_weighted(const Gradient& f, const Gradient& g,
                                                  const std::array<Floats, 3>& w) {
    return w[0] * f[0] * g[0] + w[1] * f[1] * g[1] + w[2] * f[2] * g[2];
}

// The spring of friction in shear is limited to what one iteration can apply.
void update_stretch_masses(std::span<StretchBlock> blocks, std::span<const StretchRecord> records,
                           const float* inverse_masses) {
    // Minimum ratio of the spring to the fabric's shear stiffness. Where the fabric is so stiff that one iteration can
    // apply no more than its stiffness (compliance -> 0), the spring makes it overshoot by this share.
    constexpr float kMinSpring = 0.25F;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        StretchBlock& block = blocks[i];
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            const std::array<Floats, 3> w{value_at(block.vertices[0], at, inverse_masses),
                                          value_at(block.vertices[1], at, inverse_masses),
                                          value_at(block.vertices[2], at, inverse_masses)};
            const Gradient a = gradient(block.a, at), b = gradient(block.b, at);
            const Floats of_warp = dot_weighted(a, a, w), of_weft = dot_weighted(b, b, w),
                         cross = dot_weighted(a, b, w);
            const Floats warp = 1.0F / (of_warp + load_at(records[i].compliance[0], at));
            const Floats weft = 1.0F / (of_weft + load_at(records[i].compliance[1], at));
            const Floats compliance = load_at(records[i].compliance[2], at);
            const Floats of_shear = of_warp + of_weft - cross * cross * (warp + weft);
            const Floats spring = lanes::min(compliance / lanes::max(of_shear, lanes::broadcast(kTiny)) + kMinSpring,
                                             lanes::broadcast(kStick));
            lanes::store(&block.warp[at], warp);
            lanes::store(&block.weft[at], weft);
            lanes::store(&block.cross[at], cross);
            lanes::store(&block.shear[at], 1.0F / (of_shear + compliance));
            lanes::store(&block.stick[at], lanes::where(load_at(block.slip, at) > 0.0F, spring));
        }
    }
}

void update_limit_masses(std::span<LimitBlock> blocks, std::span<LimitRecord> records, const float* masses) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        LimitBlock& block = blocks[i];
        LimitRecord& record = records[i];
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            std::array<Floats, 3> w;
            for (std::size_t k = 0; k < 3; ++k) {
                const Floats mass = value_at(block.vertices[k], at, masses);
                w[k] = lanes::where(mass > 0.0F, 1.0F / lanes::max(mass, lanes::broadcast(kTiny)));
            }
            const Gradient a = gradient(block.a, at), b = gradient(block.b, at);
            const Floats of_warp = dot_weighted(a, a, w), of_weft = dot_weighted(b, b, w);
            const std::array<Floats, 3> seen{of_warp, of_weft, of_warp + of_weft};
            std::array<Floats, 3> gain;
            for (std::size_t k = 0; k < 3; ++k) {
                const Floats compliance = load_at(record.compliance[k], at);
                gain[k] = kLimitShare / (seen[k] + compliance);
                lanes::store(&record.per_stress[k][at], 1.0F / (gain[k] * compliance));
                lanes::store(&block.warp[k][at], w[k] * a[k]);
                lanes::store(&block.weft[k][at], w[k] * b[k]);
            }
            lanes::store(&block.gain[0][at], gain[0]);
            lanes::store(&block.gain[1][at], gain[1]);
            lanes::store(&record.per_shear[at], gain[2]);
            apply_bias(block, record, at);
        }
    }
}

void predict(float* points, float* before, float* lost, std::size_t count, const Motion& motion) {
    Floats fall{};
    for (std::size_t i = 0; i < lanes::kCount; ++i) fall[i] = i % 4 < 3 ? motion.fall[i % 4] : 0.0F;
    const Floats keep = lanes::broadcast(motion.keep);
    for (std::size_t i = 0; i < 4 * count; i += lanes::kCount) {  // w does not change: its displacement is 0
        const Floats x = lanes::load(points + i);
        const Floats move = lanes::multiply_add(x - lanes::load(before + i), keep, fall) + lanes::load(lost + i);
        const Floats moved = x + lanes::where(lanes::w_components(x) > 0.0F, move);
        lanes::store(lost + i, lanes::where(lanes::w_components(x) > 0.0F, move - (moved - x)));
        lanes::store(before + i, x);
        lanes::store(points + i, moved);
    }
}

void add_momentum(const CorrectedPoints& corrected, std::size_t count, float momentum) {
    for (std::size_t i = 0; i < 4 * count; i += lanes::kCount) {  // w does not change: its correction is 0
        const Floats x = lanes::load(corrected.points + i);
        const Floats again = lanes::where(lanes::w_components(x) > 0.0F, lanes::load(corrected.correction + i));
        const Floats moved = lanes::multiply_add(again, lanes::broadcast(momentum), x);
        lanes::store(corrected.predicted + i, x);
        lanes::store(corrected.points + i, moved);
        lanes::store(corrected.start + i, moved);
    }
}

void store_corrections(const CorrectedPoints& corrected, std::size_t count) {
    for (std::size_t i = 0; i < 4 * count; i += lanes::kCount) {
        lanes::store(corrected.correction + i,
                     lanes::load(corrected.points + i) - lanes::load(corrected.predicted + i));
    }
}

void prolong_centres(std::span<const EdgeCentre> centres, const float* before, float* points) {
    using Point __attribute__((vector_size(16))) = float;
    const auto at = [](const float* from, std::uint32_t offset) {
        Point p;
        std::memcpy(&p, from + offset, sizeof p);
        return p;
    };
    for (const EdgeCentre& c : centres) {
        const Point moved = (at(points, c.a) - at(before, c.a)) + (at(points, c.b) - at(before, c.b));
        const Point centre = at(points, c.centre) + moved * 0.5F;
        std::memcpy(points + c.centre, &centre, sizeof centre);
    }
}

// Damps the velocities of the corners relative to their mean. Impulses act in proportion to inverse mass, so linear
// momentum is conserved.
[[gnu::always_inline]] inline Corners damped(const Corners& now, const Corners& was, float share) {
    Corners slower;
    for (int j = 0; j < 4; ++j) {
        const Floats v0 = now.x0.row[j] - was.x0.row[j];
        const Floats v1 = now.x1.row[j] - was.x1.row[j];
        const Floats v2 = now.x2.row[j] - was.x2.row[j];
        const Floats w0 = lanes::w_components(now.x0.row[j]);
        const Floats w1 = lanes::w_components(now.x1.row[j]);
        const Floats w2 = lanes::w_components(now.x2.row[j]);
        const Floats mean = (v0 + v1 + v2) * lanes::broadcast(1.0F / 3.0F);
        const Floats gain = lanes::broadcast(share) / lanes::max(w0 + w1 + w2, lanes::broadcast(kTiny));
        slower.x0.row[j] = lanes::multiply_add(v0 - mean, w0 * gain, was.x0.row[j]);
        slower.x1.row[j] = lanes::multiply_add(v1 - mean, w1 * gain, was.x1.row[j]);
        slower.x2.row[j] = lanes::multiply_add(v2 - mean, w2 * gain, was.x2.row[j]);
    }
    return slower;
}

void update_bias(std::span<StretchBlock> blocks, std::span<const StretchRecord> records, const float* points,
                 const float* before, const BiasGains& gains, const StressSums& sums) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        StretchBlock& block = blocks[i];
        const StretchRecord& record = records[i];
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            const YarnDirections t = mean_directions(block, at, points, before);
            const Xyz own = stress_of(record, at);
            const Xyz all = sum_of(own, load_stress(sums.above, &record.parent[at]));
            // Where the cloth is gathered, only tension is accumulated.
            const Floats push = load_at(block.push, at);
            const Floats least = push * lanes::broadcast(gains.least);
            const auto felt = [&](Floats off) { return lanes::max(off, push * off); };
            const Floats warp_off = t.warp_length - 1.0F - all.x;
            const Floats weft_off = t.weft_length - 1.0F - all.y;
            const Floats of_area = load_at(record.of_area, at);
            add_stress(sums.below, &record.parent[at], {own.x * of_area, own.y * of_area, own.z * of_area});
            add_stress(sums.off, &record.parent[at], {felt(warp_off) * of_area, felt(weft_off) * of_area, Floats{}});
            move_bias(block.bias[0], at, warp_off, gains.stretch, least, gains.most);
            move_bias(block.bias[1], at, weft_off, gains.stretch, least, gains.most);
            const Floats shear = dot(t.warp, t.weft);
            // The full spring: the bias follows the fabric, not the stiffness that one iteration can apply.
            const Floats friction_strain = clamped(shear - load_at(block.anchor, at), load_at(block.slip, at)) * kStick;
            move_bias(block.bias[2], at, shear + friction_strain - all.z, gains.shear,
                      lanes::broadcast(-kMoreShear * gains.most), kMoreShear * gains.most);
        }
    }
}

void apply_internal_damping(std::span<const StretchBlock> blocks, const float* points, float* before, float share) {
    for (const StretchBlock& block : blocks) {
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            const Corners now = corners_of(block, at, points);
            put_corners(block, at, damped(now, corners_of(block, at, before), share), before);
        }
    }
}

}  // namespace

}  // namespace selvedge::sim
