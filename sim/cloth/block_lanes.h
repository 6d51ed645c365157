#pragma once
// Single lanes of blocks: rows of sixteen values of four bytes, `vertices` the first of them.
#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <type_traits>

#include "sim/cloth/solver_blocks.h"

namespace selvedge {

// Spare lanes stand on a point of its own behind those of the mesh, which cannot move.
template <class Block>
Block spare_block(std::size_t spare_point) {
    Block block{};
    for (BlockPoints& points : block.vertices) points.fill(static_cast<std::uint32_t>(4 * spare_point));
    if constexpr (std::is_same_v<Block, StretchBlock> || std::is_same_v<Block, OverBlock>)
        block.longest.fill(std::numeric_limits<float>::max());
    if constexpr (std::is_same_v<Block, StretchBlock>) block.push.fill(1);  // not gathered
    if constexpr (std::is_same_v<Block, LimitBlock>) {
        block.longest_warp.fill(1);
        block.longest_weft.fill(1);
    }
    return block;
}

// Compliances that only keep the gains of spare lanes finite.
template <class Record>
Record spare_record() {
    Record record{};
    if constexpr (!std::is_same_v<Record, BendRecord>) {
        for (BlockFloats& compliance : record.compliance) compliance.fill(1);
    }
    if constexpr (std::is_same_v<Record, LimitRecord>) {
        for (BlockFloats& length : record.free_length) length.fill(1);
    }
    return record;
}

template <class Block>
void copy_lane(const Block& from, Block& to, std::size_t at) {
    constexpr std::size_t kValue = sizeof(float), kRow = kBlock * kValue;
    static_assert(sizeof(Block) % kRow == 0 && std::is_trivially_copyable_v<Block>);
    const auto* source = static_cast<const std::byte*>(static_cast<const void*>(&from));
    auto* target = static_cast<std::byte*>(static_cast<void*>(&to));
    for (std::size_t place = at * kValue; place < sizeof(Block); place += kRow) {
        std::memcpy(target + place, source + place, kValue);
    }
}

// Three figures of one lane.
inline Vec3f lane_of(const std::array<BlockFloats, 3>& rows, std::size_t at) {
    return {rows[0][at], rows[1][at], rows[2][at]};
}
inline void set_lane(std::array<BlockFloats, 3>& rows, std::size_t at, const Vec3f& values) {
    for (std::size_t k = 0; k < 3; ++k) rows[k][at] = values[static_cast<Eigen::Index>(k)];
}

// Vertex indices.
template <class Block>
auto corners_at(const Block& block, std::size_t at) {
    std::array<std::uint32_t, std::tuple_size_v<decltype(Block::vertices)>> corners{};
    for (std::size_t k = 0; k < corners.size(); ++k) corners[k] = block.vertices[k][at] / 4;
    return corners;
}

}  // namespace selvedge
