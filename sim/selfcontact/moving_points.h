#pragma once
// The vertices that self-contact moves.
#include <cstddef>
#include <cstdint>

#include "sim/core/math.h"

namespace selvedge::sim {

inline Vec4f point_without_w(const float* point) {
    return Eigen::Map<const Vec4f, Eigen::Aligned16>(point).cwiseProduct(Vec4f(1, 1, 1, 0));
}

// By vertex, four floats, of which the fourth is the inverse mass (1/kg).
struct MovingPoints {
    float* now = nullptr;
    float* before = nullptr;  // one sub-step ago
    std::size_t count = 0;    // vertices, without the dummy vertex

    Vec3f at(std::uint32_t v) const { return Eigen::Map<const Vec3f>(now + 4 * static_cast<std::size_t>(v)); }
    Vec3f was_at(std::uint32_t v) const { return Eigen::Map<const Vec3f>(before + 4 * static_cast<std::size_t>(v)); }
    // The same with a w of 0, in one vector of the processor.
    Vec4f wide_at(std::uint32_t v) const { return point_without_w(now + 4 * static_cast<std::size_t>(v)); }
    Vec4f wide_was_at(std::uint32_t v) const { return point_without_w(before + 4 * static_cast<std::size_t>(v)); }
    float inverse_mass(std::uint32_t v) const { return now[4 * static_cast<std::size_t>(v) + 3]; }
    // Moves a vertex without changing its velocity.
    void shift(std::uint32_t v, const Vec3f& by) const {
        Eigen::Map<Vec3f>(now + 4 * static_cast<std::size_t>(v)) += by;
        Eigen::Map<Vec3f>(before + 4 * static_cast<std::size_t>(v)) += by;
    }
};

}  // namespace selvedge::sim
