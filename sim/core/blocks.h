#pragma once
// Blocks of sixteen values, as the kernels read them: structures of arrays, one slot per constraint, sample or pair.
#include <array>
#include <cstddef>
#include <cstdint>

namespace selvedge::sim {

inline constexpr std::size_t kBlock = 16;
using BlockFloats = std::array<float, kBlock>;
using BlockPoints = std::array<std::uint32_t, kBlock>;  // offset of a vertex's floats: four times its index

}  // namespace selvedge::sim
