#pragma once
// Blocks of sixteen values, as the kernels read them: structures of arrays, one slot per constraint, sample or pair.
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace selvedge::sim {

inline constexpr std::size_t kBlock = 16;
using BlockFloats = std::array<float, kBlock>;
using BlockPoints = std::array<std::uint32_t, kBlock>;  // offset of a vertex's floats: four times its index

// Appends to a list that grows by a quarter, not twofold as push_back(): blocks are most of a garment's memory.
template <class Block>
void append_block(std::vector<Block>& blocks, const Block& block) {
    if (blocks.size() == blocks.capacity()) blocks.reserve(blocks.size() + blocks.size() / 4 + 1);
    blocks.push_back(block);
}

}  // namespace selvedge::sim
