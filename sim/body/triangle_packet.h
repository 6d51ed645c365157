#pragma once
// Eight triangles at once: squared distances from a point, what trees and grids over a surface end in.  (SPEC 3.3)
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "sim/body/group_kernel.h"
#include "sim/body/packet_kernel.h"
#include "sim/core/vec.h"

namespace selvedge {

struct TrianglePacket {
    static constexpr std::size_t kLanes = 8;
    using Lanes = std::array<float, kLanes>;

    std::array<Lanes, 3> corner, edge1, edge2;   // first corner and the two edges from it, m
    std::array<std::uint32_t, kLanes> triangle;  // spare lanes repeat the last
};

// Pre: 1 to 8 `chosen`, which are indices into triangles.
TrianglePacket make_packet(std::span<const Vec3f> points, std::span<const std::array<std::uint32_t, 3>> triangles,
                           std::span<const std::uint32_t> chosen);

struct NearestTriangle {
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    float squared = 0;  // m^2, nothing farther counts
    std::uint32_t triangle = kNone;
    bool found() const { return triangle != kNone; }

    // Of triangles equally far the first that was tested stays.
    void test(PacketKernel kernel, const TrianglePacket& packet, const Vec3f& p) {
        TrianglePacket::Lanes squares;
        unsigned nearer = kernel(packet.corner[0].data(), p.data(), squared, squares.data());
        for (; nearer != 0; nearer &= nearer - 1) {
            const std::size_t i = std::size_t(std::countr_zero(nearer));
            if (squares[i] >= squared) continue;
            squared = squares[i];
            triangle = packet.triangle[i];
        }
    }
};

// Points that lie close together, and what is nearest to each. Spare lanes repeat one.
struct alignas(64) PointGroup {
    static constexpr std::size_t kPoints = 16;

    std::array<float, kPoints> x{}, y{}, z{};  // m
    std::array<float, kPoints> squared{};      // m^2, nothing farther counts
    std::array<std::uint32_t, kPoints> triangle{};

    Vec3f point(std::size_t lane) const { return {x[lane], y[lane], z[lane]}; }
    // Forgets what was found and looks no farther than this.
    void start(std::size_t lane, const Vec3f& p, float radius) {
        x[lane] = p.x();
        y[lane] = p.y();
        z[lane] = p.z();
        squared[lane] = radius * radius;
        triangle[lane] = NearestTriangle::kNone;
    }
};

}  // namespace selvedge
