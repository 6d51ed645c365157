#pragma once
// The kernel of packet_kernel.h, written once for any number of lanes.
#include "sim/body/packet_kernel.h"
#include "sim/core/simd_lanes.h"

namespace selvedge {

// Without branches: inside the triangle the plane's foot, else the best of three edges.
[[gnu::always_inline]] inline lanes::Floats squared_distances(const float* row, const float* p) {
    using lanes::Floats;
    constexpr std::size_t kRow = 8;
    const Floats tiny = lanes::all(1e-30F);  // keeps quotients finite on slivers

    const Floats x = p[0] - lanes::load(row), y = p[1] - lanes::load(row + kRow),
                 z = p[2] - lanes::load(row + 2 * kRow);
    const Floats bx = lanes::load(row + 3 * kRow), by = lanes::load(row + 4 * kRow), bz = lanes::load(row + 5 * kRow);
    const Floats cx = lanes::load(row + 6 * kRow), cy = lanes::load(row + 7 * kRow), cz = lanes::load(row + 8 * kRow);
    const Floats d1 = bx * x + by * y + bz * z;
    const Floats d2 = cx * x + cy * y + cz * z;
    const Floats bb = bx * bx + by * by + bz * bz;
    const Floats cc = cx * cx + cy * cy + cz * cz;
    const Floats bc = bx * cx + by * cy + bz * cz;
    const Floats area = bb * cc - bc * bc;
    const Floats v = cc * d1 - bc * d2;
    const Floats w = bb * d2 - bc * d1;
    const Floats t1 = lanes::held_to_unit(d1 / (bb + tiny));
    const Floats t2 = lanes::held_to_unit(d2 / (cc + tiny));
    const Floats t3 = lanes::held_to_unit((d2 - d1 - bc + bb) / (bb + cc - 2 * bc + tiny));
    const Floats r3 = 1 - t3;
    const Floats g1 = t1 * (t1 * bb - 2 * d1);
    const Floats g2 = t2 * (t2 * cc - 2 * d2);
    const Floats g3 = r3 * (r3 * bb - 2 * d1) + t3 * (t3 * cc - 2 * d2) + 2 * r3 * t3 * bc;
    const auto on_third = g3 < lanes::lesser(g1, g2);
    const auto on_first = g1 <= g2;
    const Floats edge_v = on_third ? r3 : lanes::where(on_first, t1);
    const Floats edge_w = on_third ? t3 : lanes::where(~on_first, t2);
    const Floats inverse = 1 / (area + tiny);
    const auto is_inside = lanes::lesser(lanes::lesser(v, w), area - v - w) >= lanes::all(0);
    const Floats s = is_inside ? v * inverse : edge_v;
    const Floats t = is_inside ? w * inverse : edge_w;
    const Floats rx = x - s * bx - t * cx, ry = y - s * by - t * cy, rz = z - s * bz - t * cz;
    return rx * rx + ry * ry + rz * rz;
}

// To be called with a type of the source's own, that no other source can name.
template <class OwnedByOneSource>
unsigned squared_distances_of(const float* packet, const float* p, float limit, float* squared) {
    constexpr std::size_t kTriangles = 8;
    unsigned nearer = 0;
    for (std::size_t i = 0; i < kTriangles; i += lanes::kCount) {
        const lanes::Floats squares = squared_distances(packet + i, p);
        lanes::store(squared + i, squares);
        nearer |= lanes::bits(squares < limit) << i;
    }
    return nearer;
}

}  // namespace selvedge
