#pragma once
// Inner loops of self-contact, compiled once per SimdLevel and selected at run time. Points are four floats: x, y, z in
// metres and w, the inverse mass (1/kg).
#include <cstddef>
#include <cstdint>
#include <span>

#include "sim/core/simd_level.h"
#include "sim/selfcontact/pairs.h"

namespace selvedge::sim {

// Arrays by triangle, padded to a multiple of sixteen. Sixteen successive triangles are a packet.
struct TriangleRows {
    std::size_t padded = 0;
    const std::uint32_t* corner[3]{};  // offsets of the vertices; those of the padding are the dummy vertex
    const std::uint32_t* sewn[3]{};    // the vertices as they are sewn (ContactSurface::sewn_as)
    const std::uint32_t* sheet{};
    const float* u{};  // m, middle in the sheet's material coordinates
    const float* v{};
    float* low[3]{};  // m, bounding box
    float* high[3]{};
    float* normal[3]{};      // unit
    float* middle[3]{};      // m
    float* packet_low[3]{};  // bounding boxes of packets, padded to a multiple of sixteen
    float* packet_high[3]{};
    const std::uint32_t* is_flat{};  // all bits set, or 0: no edge near the triangle is bent sharply
};

// Expected motion of the vertices until the next detection, in a frame that travels with the cloth.
struct Sweep {
    const float* moves = nullptr;  // by vertex, four floats: displacement per sub-step, m
    float substeps = 0;
    std::array<float, 3> frame{};  // m, the frame's origin
};

// The distance within which a pair is kept is its radius plus `margin`, plus the distance by which its sides approach
// each other along the normal during the sweep; at least `least`.
struct PairReach {
    float margin = 0;  // m
    float least = 0;   // m
};

struct SelfContactKernels {
    // Computes boxes and middles, in the sweep's frame, and normals of the triangles of a packet. Boxes hold the
    // triangle before and after the sweep, and are grown by `grow` (m).
    void (*bound_packet)(const TriangleRows& rows, std::size_t packet, const float* points, const Sweep& sweep,
                         float grow);

    // Writes the pairs of triangles with overlapping boxes, of which the first is in that packet; returns their number.
    // The second is a later triangle or one of an earlier packet that is not in `asked` (a bit per packet, sixteen per
    // number): if all packets of `asked` are searched, each pair is found once. Leaves out pairs that cannot touch
    // because the cloth between them is nearly flat. `pairs` must hold 16 times `padded` pairs.
    std::size_t (*find_pairs)(const TriangleRows& rows, std::size_t packet, const std::uint32_t* asked,
                              TrianglePair* pairs);

    // Returns a bit for each of sixteen pairs of triangles whose boxes overlap and of which neither is on one side of
    // the other's plane: only those can cross.
    unsigned (*find_piercing)(const TriangleRows& rows, const TrianglePair* pairs, const float* points);

    // Computes the closest points of sixteen pairs: weights, normal, divider and gap. Returns a bit for each pair
    // within reach.
    unsigned (*measure_pairs)(PairKind kind, PairBlock& block, const float* points, const Sweep& sweep,
                              const PairReach& reach);

    // Updates weights and normals of sixteen pairs. Returns a bit for each pair that can touch within the next
    // `substeps`, of edges only those whose closest points are inside of both: the others are those of a vertex and a
    // triangle too. before: positions one sub-step ago.
    unsigned (*refresh_pairs)(PairKind kind, PairBlock& block, const float* points, const float* before, float margin,
                              float substeps);

    // Solves contacts in order. If the sides of one are nearer than its radius, the approaching motion since `before`
    // stops, with friction; the rest of the depth is removed without changing velocities, by at most `longest_push`.
    // Of a block, those act whose sides are too near before its first one acts. Returns the number that acted.
    std::size_t (*solve_contacts)(std::span<const SelfContactBlock> blocks, float* points, float* before);

    // Returns a bit for each pair whose sides are less than `gap_share` times its gap, and less than `radius_share`
    // times its radius, apart along the dividing plane. least_slack: how much farther apart they are than that, m, in
    // the pair for which it is least.
    unsigned (*find_undivided)(PairKind kind, const PairBlock& block, const float* points, float gap_share,
                               float radius_share, float& least_slack);
};

const SelfContactKernels& self_contact_kernels(SimdLevel level);

// The kernels of one level, defined by the compilation of kernels_simd.cpp for that level.
template <SimdLevel>
const SelfContactKernels& self_contact_kernels_of();

}  // namespace selvedge::sim
