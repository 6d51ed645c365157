#include "sim/body/triangle_packet.h"

#include <algorithm>
#include <cstddef>

#include "sim/core/assert.h"
#include "sim/core/simd_level.h"

namespace selvedge {

// Kernels take a packet for nine rows of floats, and a group for four.
static_assert(offsetof(TrianglePacket, triangle) == 9 * sizeof(TrianglePacket::Lanes));
static_assert(offsetof(PointGroup, triangle) == 4 * PointGroup::kPoints * sizeof(float));

TrianglePacket make_packet(std::span<const Vec3f> points, std::span<const std::array<std::uint32_t, 3>> triangles,
                           std::span<const std::uint32_t> chosen) {
    SELVEDGE_ASSERT(!chosen.empty() && chosen.size() <= TrianglePacket::kLanes);
    TrianglePacket packet{};
    for (std::size_t lane = 0; lane < TrianglePacket::kLanes; ++lane) {
        packet.triangle[lane] = chosen[std::min(lane, chosen.size() - 1)];
        const auto [a, b, c] = triangles[packet.triangle[lane]];
        const Vec3f edge1 = points[b] - points[a];
        const Vec3f edge2 = points[c] - points[a];
        for (int axis = 0; axis < 3; ++axis) {
            packet.corner[std::size_t(axis)][lane] = points[a][axis];
            packet.edge1[std::size_t(axis)][lane] = edge1[axis];
            packet.edge2[std::size_t(axis)][lane] = edge2[axis];
        }
    }
    return packet;
}

PacketKernel packet_kernel() {
    return simd_level() == SimdLevel::Plain ? &squared_distances_plain : &squared_distances_avx2;
}

GroupKernel group_kernel() {
    switch (simd_level()) {
        case SimdLevel::Plain:
            return &nearest_in_packet_plain;
        case SimdLevel::Avx2:
            return &nearest_in_packet_avx2;
        case SimdLevel::Avx512:
            break;
    }
    return &nearest_in_packet_avx512;
}

}  // namespace selvedge
