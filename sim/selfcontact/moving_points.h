#pragma once
// The vertices that self-contact moves.
#include <cstddef>
#include <cstdint>

#include "sim/core/math.h"

namespace selvedge::sim {

// By vertex, four floats, of which the fourth is the inverse mass (1/kg).
struct MovingPoints {
    float* now = nullptr;
    float* before = nullptr;  // one sub-step ago
    std::size_t count = 0;    // vertices, without the dummy vertex

    Vec3f at(std::uint32_t v) const { return Eigen::Map<const Vec3f>(now + 4 * static_cast<std::size_t>(v)); }
    Vec3f was_at(std::uint32_t v) const { return Eigen::Map<const Vec3f>(before + 4 * static_cast<std::size_t>(v)); }
    float inverse_mass(std::uint32_t v) const { return now[4 * static_cast<std::size_t>(v) + 3]; }
    // Moves a vertex without changing its velocity.
    void shift(std::uint32_t v, const Vec3f& by) const {
        Eigen::Map<Vec3f>(now + 4 * static_cast<std::size_t>(v)) += by;
        Eigen::Map<Vec3f>(before + 4 * static_cast<std::size_t>(v)) += by;
    }
};

}  // namespace selvedge::sim
