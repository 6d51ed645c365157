#pragma once
// Sorting constraints into blocks of sixteen that share no vertex, so that a block may be computed at once.
#include <cstdint>
#include <vector>

#include "sim/cloth/solver_blocks.h"

namespace selvedge {

// Greedy: each constraint gets the first colour that none of its vertices has. All at once, in the order of calling
// add(), blocks of one colour behind each other; then one by one, as constraints come and go: what comes takes a slot
// that is free in a block of its colour, or a new block at the end. Keeps its memory between uses.
class BlockColoring {
 public:
    // Forgets all constraints. Vertices are below this number.
    void start(std::size_t vertices);

    // Constraint by constraint; vertices: N indices.
    template <std::size_t N>
    void add(const std::array<std::uint32_t, N>& vertices) {
        colors_.push_back(color_for(vertices));
    }

    // The slot of each constraint, in the order of adding: block slot / kBlock, place slot % kBlock. Every colour
    // begins a new block.
    const std::vector<std::uint32_t>& assign();
    std::size_t block_count() const { return block_colors_.size(); }  // after assign()

    // After assign(). insert() gives a slot; block_count() may be one more then.
    template <std::size_t N>
    std::uint32_t insert(const std::array<std::uint32_t, N>& vertices) {
        return take_slot(color_for(vertices));
    }
    // Pre: the constraint that has this slot has these vertices.
    template <std::size_t N>
    void remove(std::uint32_t slot, const std::array<std::uint32_t, N>& vertices) {
        const std::uint32_t color = block_colors_[slot / kBlock];
        if (color < kColors) {
            for (const std::uint32_t v : vertices) used_[v] &= ~(std::uint64_t{1} << color);
        }
        free_slots_[list_of(color)].push_back(slot);
    }

    // By block. Constraints of one colour share no vertex, whichever blocks they stand in.
    const std::vector<std::uint32_t>& colors() const { return block_colors_; }

    // Blocks of one colour, one behind the other.
    struct Run {
        std::size_t first, count;
    };
    // All blocks, in their order.
    const std::vector<Run>& runs() const { return runs_; }

 private:
    // From there on: of vertices that have them all; such constraints get blocks, and colours, of their own.
    static constexpr std::uint32_t kColors = 64;
    static constexpr std::size_t list_of(std::uint32_t color) { return color < kColors ? color : kColors; }

    template <std::size_t N>
    std::uint32_t color_for(const std::array<std::uint32_t, N>& vertices) {
        std::uint64_t used = 0;
        for (const std::uint32_t v : vertices) used |= used_[v];
        if (~used == 0) return kColors;
        const auto color = static_cast<std::uint32_t>(__builtin_ctzll(~used));
        for (const std::uint32_t v : vertices) used_[v] |= std::uint64_t{1} << color;
        return color;
    }
    std::uint32_t take_slot(std::uint32_t color);
    void add_block(std::uint32_t color);

    std::vector<std::uint64_t> used_;    // by vertex: a bit for each colour
    std::vector<std::uint32_t> colors_;  // by constraint, between start() and assign()
    std::vector<std::uint32_t> slots_;
    std::vector<std::uint32_t> block_colors_;
    std::array<std::vector<std::uint32_t>, kColors + 1> free_slots_{};  // by colour, the next last
    std::vector<Run> runs_;
    std::uint32_t alone_ = 0;  // blocks of one constraint
};

}  // namespace selvedge
