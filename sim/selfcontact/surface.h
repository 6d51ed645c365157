#pragma once
// The triangle surface of one or several garments as self-contact reads it: which triangles, edges and vertices belong
// together, and what the sheets of cloth are. It knows nothing of adaptive meshes.
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

inline constexpr std::uint32_t kNoElement = std::numeric_limits<std::uint32_t>::max();

// A piece of cloth of one fabric: a panel of a garment.
struct ContactSheet {
    float thickness = 0.0005F;  // m
    float friction = 0.3F;      // Coulomb coefficient, cloth on cloth
    int layer = 0;              // a higher layer lies farther out; equal layers have no order
};

struct ContactTriangle {
    std::array<std::uint32_t, 3> vertices{};
    std::array<std::uint32_t, 3> edges{};  // indices into ContactSurface::edges; edges[k] joins vertices k and k + 1
    std::uint32_t sheet = 0;               // index into ContactSurface::sheets
    Vec2f middle = Vec2f::Zero();          // m, in the sheet's material coordinates
};

struct ContactEdge {
    std::array<std::uint32_t, 2> ends{};
    std::array<std::uint32_t, 2> triangles{kNoElement, kNoElement};  // the second one is missing at a border
    float rest_length = 0;                                           // m
};

struct ContactSurface {
    std::vector<ContactTriangle> triangles;  // in an order in which successive ones are near each other
    std::vector<ContactEdge> edges;
    std::vector<ContactSheet> sheets;
    // By vertex: vertices with the same number are sewn together, or will be, and count as one. Empty: each is its own.
    std::vector<std::uint32_t> sewn;

    std::uint32_t sewn_as(std::uint32_t vertex) const { return sewn.empty() ? vertex : sewn[vertex]; }

    // Whether the triangle has one of these vertices, or one that is sewn to it.
    bool has_any(const ContactTriangle& triangle, std::span<const std::uint32_t> vertices) const {
        return std::ranges::any_of(vertices, [&](std::uint32_t v) {
            return std::ranges::any_of(triangle.vertices, [&](std::uint32_t w) { return sewn_as(v) == sewn_as(w); });
        });
    }
};

}  // namespace selvedge::sim
