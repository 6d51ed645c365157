#pragma once
// The kernel of group_kernel.h, written once for any number of lanes.
#include "sim/body/group_kernel.h"
#include "sim/core/simd_lanes.h"

namespace selvedge {

inline constexpr std::size_t kGroupPoints = 16;
inline constexpr std::size_t kGroupTriangles = 8;

// What is the same for every point: products of a triangle's edges and reciprocals.
struct TriangleProducts {
    float bb[kGroupTriangles], cc[kGroupTriangles], bc[kGroupTriangles];
    float per_bb[kGroupTriangles], per_cc[kGroupTriangles], per_third[kGroupTriangles], per_area[kGroupTriangles];
};

[[gnu::always_inline]] inline void multiply_edges(const float* packet, TriangleProducts& to) {
    constexpr float kTiny = 1e-30F;  // keeps quotients finite on slivers
    const float* b = packet + 3 * kGroupTriangles;
    const float* c = packet + 6 * kGroupTriangles;
    constexpr std::size_t kY = kGroupTriangles;
    constexpr std::size_t kZ = 2 * kGroupTriangles;
    for (std::size_t i = 0; i < kGroupTriangles; ++i) {
        const float bb = b[i] * b[i] + b[kY + i] * b[kY + i] + b[kZ + i] * b[kZ + i];
        const float cc = c[i] * c[i] + c[kY + i] * c[kY + i] + c[kZ + i] * c[kZ + i];
        const float bc = b[i] * c[i] + b[kY + i] * c[kY + i] + b[kZ + i] * c[kZ + i];
        to.bb[i] = bb;
        to.cc[i] = cc;
        to.bc[i] = bc;
        to.per_bb[i] = 1 / (bb + kTiny);
        to.per_cc[i] = 1 / (cc + kTiny);
        to.per_third[i] = 1 / (bb + cc - 2 * bc + kTiny);
        to.per_area[i] = 1 / (bb * cc - bc * bc + kTiny);
    }
}

struct LanePoints {
    lanes::Floats x, y, z;
};

// Without branches: inside the triangle the plane's foot, else the best of three edges.
[[gnu::always_inline]] inline lanes::Floats squared_distance_to(const float* packet, const TriangleProducts& products,
                                                                std::size_t i, const LanePoints& p) {
    using lanes::Floats;
    const float* row = packet + i;
    const float bx = row[3 * kGroupTriangles], by = row[4 * kGroupTriangles], bz = row[5 * kGroupTriangles],
                cx = row[6 * kGroupTriangles], cy = row[7 * kGroupTriangles], cz = row[8 * kGroupTriangles];
    const float bb = products.bb[i], cc = products.cc[i], bc = products.bc[i];

    const Floats x = p.x - row[0 * kGroupTriangles], y = p.y - row[1 * kGroupTriangles],
                 z = p.z - row[2 * kGroupTriangles];
    const Floats d1 = bx * x + by * y + bz * z;
    const Floats d2 = cx * x + cy * y + cz * z;
    const Floats v = (cc * d1 - bc * d2) * products.per_area[i];
    const Floats w = (bb * d2 - bc * d1) * products.per_area[i];
    const Floats t1 = lanes::held_to_unit(d1 * products.per_bb[i]);
    const Floats t2 = lanes::held_to_unit(d2 * products.per_cc[i]);
    const Floats t3 = lanes::held_to_unit((d2 - d1 - bc + bb) * products.per_third[i]);
    const Floats r3 = 1 - t3;
    const Floats g1 = t1 * (t1 * bb - 2 * d1);
    const Floats g2 = t2 * (t2 * cc - 2 * d2);
    const Floats g3 = r3 * (r3 * bb - 2 * d1) + t3 * (t3 * cc - 2 * d2) + 2 * r3 * t3 * bc;
    const auto on_third = g3 < lanes::lesser(g1, g2);
    const auto on_first = g1 <= g2;
    const Floats edge_v = on_third ? r3 : lanes::where(on_first, t1);
    const Floats edge_w = on_third ? t3 : lanes::where(~on_first, t2);
    const auto is_inside = lanes::lesser(lanes::lesser(v, w), 1 - v - w) >= lanes::all(0);
    const Floats s = is_inside ? v : edge_v;
    const Floats t = is_inside ? w : edge_w;
    const Floats rx = x - s * bx - t * cx, ry = y - s * by - t * cy, rz = z - s * bz - t * cz;
    return rx * rx + ry * ry + rz * rz;
}

[[gnu::always_inline]] inline lanes::Floats squared_distance_to_box(const float* box, const LanePoints& p) {
    using lanes::Floats;
    const Floats zero = lanes::all(0);
    const Floats x = lanes::greater(zero, lanes::greater(box[0] - p.x, p.x - box[3]));
    const Floats y = lanes::greater(zero, lanes::greater(box[1] - p.y, p.y - box[4]));
    const Floats z = lanes::greater(zero, lanes::greater(box[2] - p.z, p.z - box[5]));
    return x * x + y * y + z * z;
}

[[gnu::always_inline]] inline LanePoints points_in(const float* rows, std::size_t lane) {
    return {lanes::load(rows + lane), lanes::load(rows + kGroupPoints + lane),
            lanes::load(rows + 2 * kGroupPoints + lane)};
}

// Whether the box is nearer to any of the points than what they have.
[[gnu::always_inline]] inline bool may_be_nearer(const float* box, const float* rows) {
    unsigned nearer = 0;
    for (std::size_t lane = 0; lane < kGroupPoints; lane += lanes::kCount)
        nearer |= lanes::bits(squared_distance_to_box(box, points_in(rows, lane)) <
                              lanes::load(rows + 3 * kGroupPoints + lane));
    return nearer != 0;
}

[[gnu::always_inline]] inline float largest_of(const float* row) {
    float largest = row[0];
    for (std::size_t i = 1; i < kGroupPoints; ++i) largest = row[i] > largest ? row[i] : largest;
    return largest;
}

// To be called with a type of the source's own, that no other source can name.
template <class OwnedByOneSource>
float nearest_in_packet(const float* packet, const std::uint32_t* ids, const float* box, float* rows,
                        std::uint32_t* nearest) {
    float* squares = rows + 3 * kGroupPoints;
    if (!may_be_nearer(box, rows)) return largest_of(squares);
    TriangleProducts products;
    multiply_edges(packet, products);
    for (std::size_t lane = 0; lane < kGroupPoints; lane += lanes::kCount) {
        const LanePoints p = points_in(rows, lane);
        lanes::Floats best = lanes::load(squares + lane);
        lanes::Ints which = lanes::load_ints(nearest + lane);
        for (std::size_t i = 0; i < kGroupTriangles; ++i) {
            const lanes::Floats squared = squared_distance_to(packet, products, i, p);
            const lanes::Ints is_nearer = squared < best;
            best = is_nearer ? squared : best;
            which = is_nearer ? lanes::all_ints(std::int32_t(ids[i])) : which;
        }
        lanes::store(squares + lane, best);
        lanes::store_ints(nearest + lane, which);
    }
    return largest_of(squares);
}

}  // namespace selvedge
