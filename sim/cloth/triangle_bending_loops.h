#pragma once
// The kernels of bending: the solve, and the update of its gains; for their contracts see kernels.h. Include it only in
// kernel sources (kernels_simd.cpp; see sim/core/simd_level.h).
#include <type_traits>

#include "sim/cloth/loop_parts.h"

namespace selvedge::sim {
namespace {

[[gnu::always_inline]] inline Xyz cross(const Xyz& p, const Xyz& q) {
    return {lanes::multiply_add(p.y, q.z, -(p.z * q.y)), lanes::multiply_add(p.z, q.x, -(p.x * q.z)),
            lanes::multiply_add(p.x, q.y, -(p.y * q.x))};
}
[[gnu::always_inline]] inline Xyz times(const Xyz& p, Floats s) {
    return {p.x * s, p.y * s, p.z * s};
}
[[gnu::always_inline]] inline Xyz minus(const Xyz& p, const Xyz& q) {
    return {p.x - q.x, p.y - q.y, p.z - q.z};
}

// A hinge: its angle, rad, and the unit normal of the triangle beyond it.
struct Fold {
    Xyz normal;
    Floats angle;
};

// Approximates an angle t from its sine and cosine by (4 tan(t/2) + sin t) / 3, see kMaxFold: error 0.06 % at 0.5 rad,
// 6 % at a right angle.
[[gnu::always_inline]] inline Floats angle_of(Floats sine, Floats cosine) {
    const Floats half = sine / lanes::max(cosine + 1.0F, lanes::broadcast(kMinFold));
    return clamped(lanes::multiply_add(half, lanes::broadcast(4.0F / 3), sine * lanes::broadcast(1.0F / 3)),
                   lanes::broadcast(kMaxFold));
}

// edge: from corner i + 1 to corner i + 2; apex: from corner i + 1 to the apex; normal: unit normal of the triangle.
[[gnu::always_inline]] inline Fold fold_of(const BendBlock& block, std::size_t i, std::size_t at, const Xyz& edge,
                                           const Xyz& apex, const Xyz& normal) {
    Fold fold;
    fold.normal = cross(apex, edge);
    normalise(fold.normal);
    fold.angle = angle_of(dot(apex, normal) * load_at(block.beyond[i], at), dot(fold.normal, normal));
    return fold;
}

// The gain, a symmetric matrix (00 11 22 01 02 12), times the angles.
[[gnu::always_inline]] inline Xyz gained(const BendBlock& block, std::size_t at, const Xyz& angles) {
    const auto gain = [&](std::size_t i) { return load_at(block.gain[i], at); };
    const Floats g01 = gain(3), g02 = gain(4), g12 = gain(5);
    return {lanes::multiply_add(gain(0), angles.x, lanes::multiply_add(g01, angles.y, g02 * angles.z)),
            lanes::multiply_add(gain(1), angles.y, lanes::multiply_add(g01, angles.x, g12 * angles.z)),
            lanes::multiply_add(gain(2), angles.z, lanes::multiply_add(g02, angles.x, g12 * angles.y))};
}

// Adds internal friction: for each curvature a spring to an anchor, which follows at a maximum distance (Prandtl
// element). The curvature used is the one expected after the whole iteration (BendBlock::settled). With the curvature
// before it, each sub-step's free fall would drag the anchors along, and friction would creep.
[[gnu::always_inline]] inline Xyz with_friction(BendBlock& block, std::size_t at, const Xyz& angles, Xyz multipliers,
                                                Floats is_solved) {
    for (std::size_t k = 0; k < 3; ++k) {
        const Floats c0 = load_at(block.map[3 * k], at), c1 = load_at(block.map[3 * k + 1], at),
                     c2 = load_at(block.map[3 * k + 2], at);
        const Floats bent = lanes::multiply_add(load_at(block.settled[3 * k], at), angles.x,
                                                lanes::multiply_add(load_at(block.settled[3 * k + 1], at), angles.y,
                                                                    load_at(block.settled[3 * k + 2], at) * angles.z));
        const Floats anchor = load_at(block.anchor[k], at);
        const Floats off = clamped(bent - anchor, load_at(block.slip[k], at));
        lanes::store(&block.anchor[k][at],
                     lanes::where(is_solved > 0.0F, bent - off) + lanes::where(is_solved <= 0.0F, anchor));
        const Floats by = load_at(block.stick[k], at) * off;
        multipliers.x = lanes::multiply_add(c0, by, multipliers.x);
        multipliers.y = lanes::multiply_add(c1, by, multipliers.y);
        multipliers.z = lanes::multiply_add(c2, by, multipliers.z);
    }
    return multipliers;
}

// Whether points are loaded a second time before they are moved. With 16 lanes this saves registers.
constexpr bool kReadsTwice = lanes::kCount == 16;

// Moves one of the six points.
template <class Block>
[[gnu::always_inline]] inline void push_point(const Block& block, std::size_t i, std::size_t at, const Rows& x, Xyz by,
                                              float* points) {
    if constexpr (std::is_same_v<Block, CoarseBendBlock>) {
        Rows moved = lanes::rows_of(times(by, load_at(block.inverse_mass[i], at)));
        for (int j = 0; j < 4; ++j) moved.row[j] = x.row[j] + moved.row[j];
        lanes::scatter_points(points, &block.vertices[i][at], moved);
    } else {
        lanes::scatter_points(points, &block.vertices[i][at], pushed(x, lanes::rows_of(by)));
    }
}

// Forces follow the derivatives of the angles: they act along the normals of both sides of a hinge, so they do not
// vanish where cloth is folded flat onto itself.  (Grinspun et al. 2006)
template <bool has_friction, class Block>
[[gnu::always_inline]] inline void bend_lanes(Block& block, std::size_t at, float* points, Floats is_solved) {
    std::array<Rows, 6> kept;
    const auto read = [&](std::size_t i) { return lanes::gather_points(points, &block.vertices[i][at]); };
    const auto read_again = [&](std::size_t i) { return kReadsTwice ? read(i) : kept[i]; };
    const Rows x0 = kept[0] = read(0);
    const auto from_first = [&](std::size_t i) {
        const Rows x = read(i);
        if constexpr (!kReadsTwice) kept[i] = x;
        return lanes::transposed(difference(x, x0));
    };
    const Xyz e1 = from_first(1), e2 = from_first(2);
    Xyz normal = cross(e1, e2);
    normalise(normal);
    const std::array<Fold, 3> fold{
        fold_of(block, 0, at, minus(e2, e1), minus(from_first(3), e1), normal),
        fold_of(block, 1, at, times(e2, lanes::broadcast(-1.0F)), minus(from_first(4), e2), normal),
        fold_of(block, 2, at, e1, from_first(5), normal)};
    const Xyz angles{fold[0].angle, fold[1].angle, fold[2].angle};
    Xyz multipliers = gained(block, at, angles);
    if constexpr (has_friction) multipliers = with_friction(block, at, angles, multipliers, is_solved);
    const std::array<Floats, 3> m{multipliers.x * is_solved, multipliers.y * is_solved, multipliers.z * is_solved};

    // Per hinge: the impulse of the apex, and the impulse of the triangle's own corners along its normal. Where a hinge
    // is missing, a corner stands for the apex; the loop over the corners writes it last, with the right value.
    std::array<Xyz, 3> apex;
    std::array<Floats, 3> own, own_end;
    for (std::size_t i = 0; i < 3; ++i) {
        apex[i] = times(fold[i].normal, -(m[i] * load_at(block.beyond[i], at)));
        push_point(block, 3 + i, at, read_again(3 + i), apex[i], points);
        own[i] = -(m[i] * load_at(block.own[i], at));
        own_end[i] = own[i] * load_at(block.own_foot[i], at);
    }
    for (std::size_t i = 0; i < 3; ++i) {  // corner i is the end of hinge i + 1, the beginning of hinge i + 2
        const std::size_t ends = (i + 1) % 3, begins = (i + 2) % 3;
        const Floats along = own[i] - own_end[ends] - (own[begins] - own_end[begins]);
        const Xyz beyond = combined(apex[ends], -load_at(block.beyond_foot[ends], at), apex[begins],
                                    load_at(block.beyond_foot[begins], at) - 1.0F);
        push_point(block, i, at, read_again(i), combined(normal, along, beyond, lanes::broadcast(1.0F)), points);
    }
}

// Solves the lanes with an interval of at most `most` sub-steps; the others do not change.
template <class Block>
[[gnu::always_inline]] inline void bend_block(Block& block, float* points, float most) {
    const bool has_friction = has_positive(block.has_friction);
    for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
        const Floats is_solved = lanes::where(load_at(block.interval, at) <= most, lanes::broadcast(1.0F));
        if (has_friction) {
            bend_lanes<true>(block, at, points, is_solved);
        } else {
            bend_lanes<false>(block, at, points, is_solved);
        }
    }
}

template <class Block>
[[gnu::always_inline]] inline void bend_blocks(std::span<Block> blocks, float* points, int interval) {
    const auto most = static_cast<float>(interval);
    for (Block& block : blocks) {
        if (has_lane(block.interval, [&](Floats of) { return of <= most; })) bend_block(block, points, most);
    }
}

void solve_bend(std::span<BendBlock> blocks, float* points, int interval) {
    bend_blocks(blocks, points, interval);
}

void solve_coarse_bend(std::span<CoarseBendBlock> blocks, float* points, int interval) {
    bend_blocks(blocks, points, interval);
}

// Symmetric 3 x 3 matrices: 00 11 22 01 02 12.
using Symmetric = std::array<Floats, 6>;
constexpr std::size_t kSymmetric[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
using Matrix = std::array<std::array<Floats, 3>, 3>;

// Sigma, the change of the angles per multiplier: the sum over the six points of w q q', 1/(kg m^2).
[[gnu::always_inline]] inline Symmetric response(const BendBlock& block, std::size_t at,
                                                 const std::array<Floats, 6>& w) {
    Floats q[3][6] = {};
    for (std::size_t i = 0; i < 3; ++i) {
        const Floats own = load_at(block.own[i], at), beyond = load_at(block.beyond[i], at);
        const Floats own_end = own * load_at(block.own_foot[i], at);
        const Floats beyond_end = beyond * load_at(block.beyond_foot[i], at);
        q[i][(i + 1) % 3] = own_end - own + (beyond_end - beyond);
        q[i][(i + 2) % 3] = -own_end - beyond_end;
        q[i][i] = own;
        q[i][3 + i] = beyond;
    }
    Symmetric sum{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i; j < 3; ++j) {
            Floats& to = sum[kSymmetric[i][j]];
            for (std::size_t v = 0; v < 6; ++v) to = lanes::multiply_add(w[v] * q[i][v], q[j][v], to);
        }
    }
    return sum;
}

[[gnu::always_inline]] inline Floats trace_of_product(const Symmetric& a, const Symmetric& b) {
    const Floats off = a[3] * b[3] + a[4] * b[4] + a[5] * b[5];
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + off * 2.0F;
}

// (1 + Sigma S / 2)^-1: the ratio of the angles after the whole iteration to those before it. The factor 1/2 is because
// neighbours that share vertices undo half of each other's corrections on average.
[[gnu::always_inline]] inline Matrix left_of_angles(const Symmetric& stiffness, const Symmetric& sigma) {
    Matrix a;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            Floats sum{};
            for (std::size_t k = 0; k < 3; ++k) {
                sum = lanes::multiply_add(sigma[kSymmetric[i][k]], stiffness[kSymmetric[k][j]], sum);
            }
            a[i][j] = sum * 0.5F + (i == j ? 1.0F : 0.0F);
        }
    }
    const auto cofactor = [&](std::size_t i, std::size_t j) {
        const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        return a[i1][j1] * a[i2][j2] - a[i1][j2] * a[i2][j1];
    };
    const Floats determinant = a[0][0] * cofactor(0, 0) + a[0][1] * cofactor(0, 1) + a[0][2] * cofactor(0, 2);
    Matrix inverse;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) inverse[i][j] = cofactor(j, i) / determinant;
    }
    return inverse;
}

// The gain: the stiffness applied to the angles expected after the iteration.
[[gnu::always_inline]] inline Symmetric gain_of(const Symmetric& stiffness, const Matrix& left) {
    Symmetric gain{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i; j < 3; ++j) {
            Floats& to = gain[kSymmetric[i][j]];
            for (std::size_t k = 0; k < 3; ++k) {
                to = lanes::multiply_add(stiffness[kSymmetric[i][k]], left[k][j], to);
            }
        }
    }
    return gain;
}

// kCap: the maximum share of a mode's error that one iteration of a triangle may correct; with more, triangles
// overshoot together with their neighbours (shares tried: docs/history/solver.md). kMaxStiffness: the resulting maximum
// of trace(S Sigma), stiffness times response.
constexpr float kCap = 0.7F;
constexpr float kMaxStiffness = 2 * kCap / (2 - kCap);

// Ratio of the springs of friction in bending to the rigidity B. They slip at a curvature of H / (2 B) (H: half of
// 2HB), about 0.2 /cm, which is small against the 0.5 to 1.5 /cm at which 2HB is measured. With stiffer springs,
// triangles of 4 mm pass so much up to coarser ones that their drapes are softer than those of larger triangles: for
// cotton by 16 points at a ratio of 4, by 6 at 2.
constexpr float kBendStick = 2;

// Share of the rigidity below which a triangle is not solved. It is left out, and not passed up either: it is not worth
// an iteration.
constexpr float kMinShare = 0.03F;

// A triangle is solved only every second sub-step, with twice the impulse, if that applies the whole requested rigidity
// (impulse method of multiple time steps; Tuckerman et al. 1992).
template <class Block>
[[gnu::always_inline]] inline void update_masses(Block& block, BendRecord& record, std::size_t at,
                                                 const std::array<Floats, 6>& w) {
    const Symmetric sigma = response(block, at, w);
    const Floats one = lanes::broadcast(1.0F);
    const Floats requested = load_at(record.requested, at);
    const Floats has_friction = load_at(block.has_friction, at);
    Symmetric stiffness;
    for (std::size_t i = 0; i < 6; ++i) stiffness[i] = load_at(record.stiffness[i], at);
    const Floats room =
        lanes::broadcast(kMaxStiffness) /
        (trace_of_product(stiffness, sigma) * lanes::multiply_add(has_friction, lanes::broadcast(kBendStick), one));
    const Floats interval = one + lanes::where(requested * 4.0F <= room, one);
    const Floats most = room / (interval * interval);
    for (Floats& s : stiffness) s = s * interval;
    lanes::store(&block.interval[at], lanes::where(requested >= kMinShare, interval) +
                                          lanes::where(requested < kMinShare, lanes::broadcast(kNeverSolved)));
    const Floats realised = lanes::where(requested >= kMinShare, lanes::min(requested, most));
    lanes::store(&record.passed_up[at], lanes::where(requested >= kMinShare, requested - realised));
    lanes::store(&block.realised[at], realised);
    for (Floats& s : stiffness) s = s * realised;
    const Matrix left = left_of_angles(stiffness, sigma);
    const Symmetric gain = gain_of(stiffness, left);
    for (std::size_t i = 0; i < 6; ++i) lanes::store(&block.gain[i][at], gain[i]);
    for (std::size_t k = 0; k < 3; ++k) {
        std::array<Floats, 3> c, settled{};
        for (std::size_t i = 0; i < 3; ++i) c[i] = load_at(block.map[3 * k + i], at);
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) settled[i] = lanes::multiply_add(c[j], left[j][i], settled[i]);
            lanes::store(&block.settled[3 * k + i][at], settled[i]);
        }
        Floats seen{};
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                seen = lanes::multiply_add(settled[i] * c[j], sigma[kSymmetric[i][j]], seen);
            }
        }
        const Floats spring = load_at(record.rigidity[k], at) * realised * (kBendStick * interval);
        const Floats stick = spring / lanes::multiply_add(seen * 0.5F, spring, one) * has_friction;
        const Floats slip =
            load_at(record.friction[k], at) * realised * interval / lanes::max(stick, lanes::broadcast(kTiny * kTiny));
        lanes::store(&block.stick[k][at], stick);
        lanes::store(&block.slip[k][at], lanes::where(stick > 0.0F, slip));
    }
}

void update_bend_masses(std::span<BendBlock> blocks, std::span<BendRecord> records, const float* inverse_masses) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            std::array<Floats, 6> w;
            for (std::size_t v = 0; v < 6; ++v) w[v] = value_at(blocks[i].vertices[v], at, inverse_masses);
            update_masses(blocks[i], records[i], at, w);
        }
    }
}

void update_coarse_bend_masses(std::span<CoarseBendBlock> blocks, std::span<BendRecord> records, const float* masses) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            std::array<Floats, 6> w;
            for (std::size_t v = 0; v < 6; ++v) {
                const Floats mass = value_at(blocks[i].vertices[v], at, masses);
                w[v] = lanes::where(mass > 0.0F, 1.0F / lanes::max(mass, lanes::broadcast(kTiny)));
                lanes::store(&blocks[i].inverse_mass[v][at], w[v]);
            }
            update_masses(blocks[i], records[i], at, w);
        }
    }
}

}  // namespace
}  // namespace selvedge::sim
