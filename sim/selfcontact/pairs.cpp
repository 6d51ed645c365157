#include "sim/selfcontact/pairs.h"

namespace selvedge::sim {
namespace {

constexpr float kFar = -1e6F;  // m

void copy_slot(const PairBlock& from, std::size_t at, PairBlock& block, std::size_t to) {
    for (std::size_t k = 0; k < 4; ++k) {
        block.vertices[k][to] = from.vertices[k][at];
        block.weight[k][to] = from.weight[k][at];
    }
    for (std::size_t k = 0; k < 3; ++k) {
        block.divider[k][to] = from.divider[k][at];
        block.normal[k][to] = from.normal[k][at];
    }
    for (std::size_t k = 0; k < 2; ++k) block.triangles[k][to] = from.triangles[k][at];
    block.radius[to] = from.radius[at];
    block.friction[to] = from.friction[at];
    block.gap[to] = from.gap[at];
    block.side[to] = from.side[at];
}

}  // namespace

void PairList::free_slot(std::size_t pair) {
    PairBlock& block = blocks_[pair / kBlock];
    const std::size_t at = pair % kBlock;
    for (BlockPoints& vertices : block.vertices) vertices[at] = 4 * dummy_;
    block.radius[at] = kFar;
    block.side[at] = 0;
}

PairBlock& PairList::open_slot() {
    const std::size_t block = size_ / kBlock;
    if (block == blocks_.size()) append_block(blocks_, {});
    if (size_ % kBlock == 0) {
        for (std::size_t i = 0; i < kBlock; ++i) free_slot(size_ + i);
    }
    return blocks_[block];
}

void PairList::add(const PairBlock& from, std::size_t at) {
    PairBlock& block = open_slot();
    copy_slot(from, at, block, size_++ % kBlock);
}

void PairList::remove(std::span<const std::size_t> pairs) {
    std::size_t end = size_, left = pairs.size();
    for (std::size_t i = 0; i < left; ++i) {
        while (left > i && pairs[left - 1] + 1 == end) {
            --left;
            --end;
        }
        if (i == left) break;
        --end;
        copy_slot(blocks_[end / kBlock], end % kBlock, blocks_[pairs[i] / kBlock], pairs[i] % kBlock);
    }
    size_ = end;
    for (std::size_t i = end; i < block_count() * kBlock; ++i) free_slot(i);
}

void SelfContactList::add(const SelfContactPlane& contact) {
    const std::size_t at = size_ % kBlock, index = size_++ / kBlock;
    if (index == blocks_.size()) append_block(blocks_, {});
    SelfContactBlock& block = blocks_[index];
    if (at == 0) {
        block = {};
        block.radius.fill(kFar);
    }
    for (std::size_t k = 0; k < 4; ++k) {
        block.vertices[k][at] = contact.vertices[k];
        block.weight[k][at] = contact.weight[k];
    }
    for (std::size_t k = 0; k < 3; ++k) block.normal[k][at] = contact.normal[k];
    block.radius[at] = contact.radius;
    block.inverse[at] = contact.inverse;
    block.friction[at] = contact.friction;
    block.longest_push[at] = contact.longest_push;
}

}  // namespace selvedge::sim
