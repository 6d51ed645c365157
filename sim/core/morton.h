#pragma once
// Morton codes: points with near codes are near each other in space (Morton 1966). For points that are searched in
// groups.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

// Two zero bits after each of the lower 16 bits.
inline std::uint64_t spread_bits(std::uint64_t bits) {
    bits = (bits | bits << 16) & 0x0000FF0000FFULL;
    bits = (bits | bits << 8) & 0x00F00F00F00FULL;
    bits = (bits | bits << 4) & 0x0C30C30C30C3ULL;
    return (bits | bits << 2) & 0x249249249249ULL;
}

// Of the cell of 4 mm round a point (m) within 100 m of the origin; points farther away share the outermost cells.
inline std::uint64_t morton_code(const Vec3f& p) {
    constexpr float kCellsPerMetre = 256;
    constexpr float kReach = 100;  // m
    std::uint64_t code = 0;
    for (std::ptrdiff_t axis = 0; axis < 3; ++axis) {
        const float cell = std::clamp((p[axis] + kReach) * kCellsPerMetre, 0.0F, 65535.0F);
        code |= spread_bits(static_cast<std::uint64_t>(cell)) << axis;
    }
    return code;
}

struct CodedPoint {
    std::uint64_t code = 0;
    std::uint32_t index = 0;  // of the point
};

// Sorts by code, and keeps the order of those with the same one. Pre: codes below 2^55; those of morton_code() have 48
// bits.
void sort_by_code(std::vector<CodedPoint>& points);

}  // namespace selvedge::sim
