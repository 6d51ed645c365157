#include "sim/selfcontact/pairs.h"

namespace selvedge::sim {
namespace {

PairBlock free_block(std::uint32_t dummy) {
    constexpr float kFar = -1e6F;  // m
    PairBlock block;
    for (BlockPoints& vertices : block.vertices) vertices.fill(4 * dummy);
    block.radius.fill(kFar);
    return block;
}

}  // namespace

PairBlock& PairList::open_slot() {
    const std::size_t block = size_ / kBlock;
    if (block == blocks_.size()) blocks_.emplace_back();
    if (size_ % kBlock == 0) blocks_[block] = free_block(dummy_);
    return blocks_[block];
}

void PairList::add(const PairBlock& from, std::size_t at) {
    PairBlock& block = open_slot();
    const std::size_t to = size_++ % kBlock;
    for (std::size_t k = 0; k < 4; ++k) {
        block.vertices[k][to] = from.vertices[k][at];
        block.weight[k][to] = from.weight[k][at];
    }
    for (std::size_t k = 0; k < 3; ++k) {
        block.divider[k][to] = from.divider[k][at];
        block.normal[k][to] = from.normal[k][at];
    }
    block.radius[to] = from.radius[at];
    block.friction[to] = from.friction[at];
    block.gap[to] = from.gap[at];
    block.side[to] = from.side[at];
}

}  // namespace selvedge::sim
