#pragma once
// The loops over hinges, see kernels.h. For kernels only (sim/core/simd_level.h).
#include "sim/cloth/loop_parts.h"

namespace selvedge {
namespace {

// By how much the force on a hinge must grow for its moment to stay in proportion to the angle: x / (sin x cos x), x
// half the angle, of sin^2 x.
[[gnu::always_inline]] inline Floats fold_share(Floats squared_sine) {
    const Floats s = lanes::lesser(squared_sine, lanes::all(1.0F));
    return lanes::multiply_add(lanes::multiply_add(s, lanes::all(8.0F / 15.0F), lanes::all(2.0F / 3.0F)), s,
                               lanes::all(1.0F));
}

struct BendGains {
    Floats gain, bow, most;
};
[[gnu::always_inline]] inline Floats folded_gain(const BendGains& g, Floats squared) {
    return lanes::lesser(g.gain * fold_share(squared * g.bow), g.most);
}

struct HingeRows {
    std::array<Rows, 4> x;
    std::array<Floats, 4> q;
};
[[gnu::always_inline]] inline HingeRows hinges_of(const BendBlock& block, std::size_t at, const float* points) {
    HingeRows hinges;
    for (std::size_t i = 0; i < 4; ++i) {
        hinges.x[i] = lanes::gather_points(points, &block.vertices[i][at]);
        hinges.q[i] = load_at(block.q[i], at);
    }
    return hinges;
}
[[gnu::always_inline]] inline void put_hinges(const BendBlock& block, std::size_t at, const HingeRows& hinges,
                                              float* points) {
    for (std::size_t i = 0; i < 4; ++i) lanes::scatter_points(points, &block.vertices[i][at], hinges.x[i]);
}

// The four points of each hinge moved by `by`, each times its q and inverse mass. Fourth floats of `by`: 0.
template <int j>
[[gnu::always_inline]] inline void push_row(HingeRows& hinges, Floats by) {
    for (std::size_t i = 0; i < 4; ++i) {
        Floats& row = hinges.x[i].row[j];
        row = lanes::multiply_add(by, lanes::spread<j>(hinges.q[i]) * lanes::fourths(row), row);
    }
}

template <int j>
[[gnu::always_inline]] inline Floats bent_row(const HingeRows& hinges) {
    Floats bent = lanes::spread<j>(hinges.q[0]) * hinges.x[0].row[j];
    for (std::size_t i = 1; i < 4; ++i) {
        bent = lanes::multiply_add(lanes::spread<j>(hinges.q[i]), hinges.x[i].row[j], bent);
    }
    return bent;
}
template <int j>
[[gnu::always_inline]] inline void push_back(HingeRows& hinges, Floats bent, Floats gain) {
    push_row<j>(hinges, lanes::with_fourths(bent * lanes::spread<j>(-gain), Floats{}));
}

void bend_purely(const BendBlock& block, float* points) {
    for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
        HingeRows hinges = hinges_of(block, at, points);
        const Rows bent{{bent_row<0>(hinges), bent_row<1>(hinges), bent_row<2>(hinges), bent_row<3>(hinges)}};
        const Xyz vector = lanes::transposed(bent);
        const Floats gain = folded_gain({load_at(block.gain, at), load_at(block.bow, at), load_at(block.most, at)},
                                        dot(vector, vector));
        push_back<0>(hinges, bent.row[0], gain);
        push_back<1>(hinges, bent.row[1], gain);
        push_back<2>(hinges, bent.row[2], gain);
        push_back<3>(hinges, bent.row[3], gain);
        put_hinges(block, at, hinges, points);
    }
}

// How a hinge is bent: the vector sum of q x, the normal between its two sides, on the fabric's right side, and what
// the vector measures along it.
struct Bent {
    Xyz vector, normal;
    Floats along;
};
[[gnu::always_inline]] inline Xyz cross(const Xyz& p, const Xyz& q) {
    return {lanes::multiply_add(p.y, q.z, -(p.z * q.y)), lanes::multiply_add(p.z, q.x, -(p.x * q.z)),
            lanes::multiply_add(p.x, q.y, -(p.y * q.x))};
}
[[gnu::always_inline]] inline Bent bent_by(const HingeRows& hinges) {
    const Xyz edge = lanes::transposed(difference(hinges.x[1], hinges.x[0]));
    const Xyz left = lanes::transposed(difference(hinges.x[2], hinges.x[0]));
    const Xyz right = lanes::transposed(difference(hinges.x[3], hinges.x[0]));
    Bent bent;
    bent.vector = combined(left, hinges.q[2], right, hinges.q[3]);
    bent.vector = combined(bent.vector, lanes::all(1.0F), edge, hinges.q[1]);
    bent.normal = cross(edge, combined(left, -hinges.q[2], right, hinges.q[3]));
    normalise(bent.normal);
    bent.along = dot(bent.vector, bent.normal);
    return bent;
}

// With friction and bias: what is seen, less half of the correction, is where the hinge will be when all have had their
// turn; the anchor follows that at a distance.
void bend_remembering(BendBlock& block, float* points) {
    for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
        HingeRows hinges = hinges_of(block, at, points);
        const Bent bent = bent_by(hinges);
        const BendGains g{load_at(block.gain, at), load_at(block.bow, at), load_at(block.most, at)};
        const Floats gain = folded_gain(g, dot(bent.vector, bent.vector));
        const Floats pull = load_at(block.pull, at);
        const Floats settled = bent.along - load_at(block.half, at) * lanes::multiply_add(gain, bent.along, pull);
        const Floats off = held_within(settled - load_at(block.anchor, at), load_at(block.slip, at));
        const Floats aside = lanes::multiply_add(load_at(block.stick, at), off, pull);
        lanes::store(&block.anchor[at], settled - off);
        lanes::store(&block.multiplier[at], lanes::multiply_add(gain, bent.along, aside));
        const Rows by = lanes::rows_of(combined(bent.vector, -gain, bent.normal, -aside));
        push_row<0>(hinges, by.row[0]);
        push_row<1>(hinges, by.row[1]);
        push_row<2>(hinges, by.row[2]);
        push_row<3>(hinges, by.row[3]);
        put_hinges(block, at, hinges, points);
    }
}

void solve_bend(std::span<BendBlock> blocks, float* points) {
    for (BendBlock& block : blocks) {
        if (has_positive(block.remembers)) {
            bend_remembering(block, points);
        } else {
            bend_purely(block, points);
        }
    }
}

// Towards what the fabric's rigidity and friction say of the curvature half-way between two sub-steps.
void update_bend(std::span<BendBlock> blocks, std::span<const BendRecord> records, const float* points,
                 const float* before, float share) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        BendBlock& block = blocks[i];
        const BendRecord& record = records[i];
        if (!has_positive(block.remembers)) continue;
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            HingeRows hinges = hinges_of(block, at, points);
            const HingeRows was = hinges_of(block, at, before);
            for (std::size_t k = 0; k < 4; ++k) hinges.x[k] = middle(hinges.x[k], was.x[k]);
            const Bent bent = bent_by(hinges);
            const Floats rigidity = load_at(record.rigidity, at);
            const Floats elastic =
                rigidity * fold_share(dot(bent.vector, bent.vector) * load_at(block.bow, at)) * bent.along;
            const Floats rubbed =
                held_within((bent.along - load_at(block.anchor, at)) * rigidity * kStick, load_at(record.limit, at));
            const Floats error = elastic + rubbed - load_at(block.multiplier, at);
            const Floats pull =
                lanes::multiply_add(error * load_at(record.learns, at), lanes::all(share), load_at(block.pull, at));
            lanes::store(&block.pull[at], held_within(pull, load_at(record.most_pull, at)));
        }
    }
}

// Of hinges that are visited every `interval` sub-steps: what a visit does lasts that long, so the move that it makes
// at once counts as often. Hinges that share vertices take half of each other's corrections away on an average, and
// what a visit takes too little adds to the compliance: where the fabric's is larger, it is made smaller by as much;
// where it is not, a pull makes up for it.
struct HingeGains {
    Floats rigidity, limit, most, half;
    Floats gain, spring, stick;
    Floats is_short;  // 1 where the fabric asks for more than a visit can give, else 0
    Floats wanted;    // gain that it asks for
};
[[gnu::always_inline]] inline HingeGains weighed(const BendBlock& block, const BendRecord& record, std::size_t at,
                                                 int interval, const float* inverse_masses) {
    constexpr float kElasticShare = 0.75F;  // of what a visit may do, if friction asks for some as well
    const float visits = static_cast<float>(interval);
    Floats sum{};
    for (std::size_t k = 0; k < 4; ++k) {
        const Floats q = load_at(block.q[k], at);
        sum = sum + value_at(block.vertices[k], at, inverse_masses) * q * q;
    }
    sum = lanes::greater(sum, lanes::all(kTiny));  // above 0 where nothing can move, too
    const Floats one = lanes::all(1.0F);
    const Floats half = sum * 0.5F;
    const Floats rigidity = visits / load_at(record.compliance[0], at);
    const Floats limit = load_at(record.friction, at) * visits;
    const auto rubs = limit > 0.0F;
    const Floats most = one / (sum * (visits * (interval > 2 ? 2.0F : 1.0F)));
    const Floats wanted = one / (one / rigidity + half);
    const Floats gain = lanes::lesser(wanted, most * (one - lanes::where(rubs, lanes::all(1 - kElasticShare))));
    const Floats left = one - half * gain;  // of what is seen, when all have had their turn
    const Floats spring = kStick * rigidity / (one + half * left * kStick * rigidity);
    const Floats stick = lanes::where(rubs, lanes::lesser(spring * left, (most - gain) / left));
    const auto is_short = (gain < wanted) | (rubs & (stick < spring * left));
    return {.rigidity = rigidity,
            .limit = limit,
            .most = most,
            .half = half,
            .gain = gain,
            .spring = spring,
            .stick = stick,
            .is_short = lanes::where(is_short, one),
            .wanted = wanted};
}

void weigh_bend(std::span<BendBlock> blocks, std::span<BendRecord> records, const HingeVisits& visits,
                const float* inverse_masses) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        BendBlock& block = blocks[i];
        BendRecord& record = records[i];
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            const HingeGains g = weighed(block, record, at, visits.interval, inverse_masses);
            const Floats most_pull = g.is_short * lanes::multiply_add(g.rigidity, load_at(record.length, at), g.limit);
            const auto remembers = (g.limit > 0.0F) | (most_pull > 0.0F);
            lanes::store(&block.gain[at], g.gain);
            lanes::store(&block.most[at], g.most);
            lanes::store(&block.remembers[at], lanes::where(remembers, lanes::all(1.0F)));
            lanes::store(&block.half[at], g.half);
            lanes::store(&block.stick[at], g.stick);
            lanes::store(&block.slip[at], g.limit / g.spring);
            lanes::store(&block.pull[at], held_within(load_at(block.pull, at) * visits.pull_scale, most_pull));
            lanes::store(&record.rigidity[at], g.rigidity);
            lanes::store(&record.limit[at], g.limit);
            lanes::store(&record.learns[at], g.gain / g.rigidity);
            lanes::store(&record.most_pull[at], most_pull);
        }
    }
}

std::size_t count_short_hinges(std::span<const BendBlock> blocks, std::span<const BendRecord> records, int interval,
                               const float* inverse_masses) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            const HingeGains g = weighed(blocks[i], records[i], at, interval, inverse_masses);
            const auto found = (g.gain * 2.0F < g.wanted) & (load_at(records[i].length, at) > 0.0F);
            count += static_cast<std::size_t>(__builtin_popcount(lanes::bits(found)));
        }
    }
    return count;
}

}  // namespace
}  // namespace selvedge
