#pragma once
// Sorting constraints into blocks of sixteen that share no vertex, so that a block may be computed at once.
#include <cstdint>
#include <vector>

#include "sim/cloth/solver_blocks.h"

namespace selvedge {

// Greedy, in the order of calling: each constraint gets the first colour that none of its vertices has. Keeps its
// memory between uses.
class BlockColoring {
 public:
    // Forgets all constraints. Vertices are below this number.
    void start(std::size_t vertices);

    // Constraint by constraint; vertices: N indices.
    template <std::size_t N>
    void add(const std::array<std::uint32_t, N>& vertices) {
        std::uint64_t used = 0;
        for (const std::uint32_t v : vertices) used |= used_[v];
        const std::uint32_t color = first_free(used);
        if (color < kColors) {
            for (const std::uint32_t v : vertices) used_[v] |= std::uint64_t{1} << color;
        }
        colors_.push_back(color);
        if (color >= counts_.size()) counts_.resize(color + 1, 0);
        ++counts_[color];
    }

    // The lane of each constraint, in the order of adding: block lane / kBlock, place lane % kBlock. Every colour
    // begins a new block.
    const std::vector<std::uint32_t>& assign();
    std::size_t block_count() const { return blocks_; }  // after assign()

 private:
    static constexpr std::uint32_t kColors = 64;  // beyond: a vertex of more; such constraints get blocks of their own

    std::uint32_t first_free(std::uint64_t used) {
        if (~used != 0) return static_cast<std::uint32_t>(__builtin_ctzll(~used));
        return kColors + alone_++;
    }

    std::vector<std::uint64_t> used_;  // by vertex: a bit for each colour
    std::vector<std::uint32_t> colors_;
    std::vector<std::uint32_t> counts_;
    std::vector<std::uint32_t> next_;
    std::vector<std::uint32_t> lanes_;
    std::uint32_t alone_ = 0;
    std::size_t blocks_ = 0;
};

}  // namespace selvedge
