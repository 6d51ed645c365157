#include "sim/cloth/constraint_set.h"

namespace selvedge::sim {
void BlockColoring::start(std::size_t vertices, Colorless colorless) {
    colorless_ = colorless;
    next_in_turn_ = 0;
    used_.assign(vertices, 0);
    colors_.clear();
    block_colors_.clear();
    for (std::vector<std::uint32_t>& slots : free_slots_) slots.clear();
    runs_.clear();
}

// Makes blocks colour by colour, so that those of one colour are consecutive. Slots are assigned in ascending order.
const std::vector<std::uint32_t>& BlockColoring::assign() {
    std::array<std::uint32_t, kColors + 1> counts{};
    for (const std::uint32_t color : colors_) ++counts[color];
    std::array<std::uint32_t, kColors + 1> next{};
    for (std::uint32_t color = 0; color <= kColors; ++color) {
        const std::uint32_t per_block = color < kColors ? kBlock : 1;
        const std::uint32_t blocks = (counts[color] + per_block - 1) / per_block;
        next[color] = static_cast<std::uint32_t>(block_colors_.size() * kBlock);
        for (std::uint32_t i = 0; i < blocks; ++i) add_block(color < kColors ? color : kColors + i);
        alone_ = color < kColors ? 0 : blocks;
        if (color == kColors) break;
        const std::uint32_t end = next[color] + blocks * static_cast<std::uint32_t>(kBlock);
        for (std::uint32_t slot = end; slot-- > next[color] + counts[color];) free_slots_[color].push_back(slot);
    }
    slots_.clear();
    for (const std::uint32_t color : colors_) {
        slots_.push_back(next[color]);
        next[color] += color < kColors ? 1 : static_cast<std::uint32_t>(kBlock);
    }
    return slots_;
}

std::uint32_t BlockColoring::take_slot(std::uint32_t color) {
    std::vector<std::uint32_t>& free = free_slots_[color];
    if (free.empty() && color == kColors && colorless_ == Colorless::InTurn) return next_in_turn();
    if (free.empty()) {
        const auto first = static_cast<std::uint32_t>(block_colors_.size() * kBlock);
        const auto count = color < kColors ? static_cast<std::uint32_t>(kBlock) : 1U;
        for (std::uint32_t i = count; i-- > 0;) free.push_back(first + i);
        add_block(color < kColors ? color : kColors + alone_++);
    }
    const std::uint32_t slot = free.back();
    free.pop_back();
    return slot;
}

// Constraints in turn fill the last block only, so that they are solved in the order of insert(), among the others too.
std::uint32_t BlockColoring::next_in_turn() {
    const bool has_room = next_in_turn_ % kBlock != 0 && block_colors_.back() >= kColors;
    if (!has_room) {
        next_in_turn_ = static_cast<std::uint32_t>(block_colors_.size() * kBlock);
        add_block(kColors + alone_++);
    }
    return next_in_turn_++;
}

void BlockColoring::add_block(std::uint32_t color) {
    if (!block_colors_.empty() && block_colors_.back() == color) {
        ++runs_.back().count;
    } else {
        runs_.push_back({block_colors_.size(), 1});
    }
    block_colors_.push_back(color);
}

}  // namespace selvedge::sim
