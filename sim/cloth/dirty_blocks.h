#pragma once
// Which blocks of a list wait for their gains: after an adaptation only those in which a constraint or a vertex' mass
// changed. A kernel takes spans of blocks, so it is called with runs of dirty blocks that lie behind one another.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/cloth/solver_blocks.h"

namespace selvedge {

class DirtyBlocks {
 public:
    void mark_slot(std::uint32_t slot) { mark_block(slot / kBlock); }
    void mark_block(std::size_t block) {
        if (block >= is_marked_.size()) is_marked_.resize(std::max(block + 1, 2 * is_marked_.size()), 0);
        if (is_marked_[block] != 0) return;
        is_marked_[block] = 1;
        marked_.push_back(static_cast<std::uint32_t>(block));
    }
    void mark_all(std::size_t blocks) {
        for (std::size_t block = 0; block < blocks; ++block) mark_block(block);
    }
    void clear() {
        for (const std::uint32_t block : marked_) is_marked_[block] = 0;
        marked_.clear();
    }

    // Calls visit(first, count) for each run, by rising number. They stay dirty until clear().
    template <class Visit>
    void for_runs(const Visit& visit) {
        std::sort(marked_.begin(), marked_.end());
        for (std::size_t i = 0; i < marked_.size();) {
            std::size_t count = 1;
            while (i + count < marked_.size() && marked_[i + count] == marked_[i] + count) ++count;
            visit(static_cast<std::size_t>(marked_[i]), count);
            i += count;
        }
    }

 private:
    std::vector<std::uint8_t> is_marked_;  // by block
    std::vector<std::uint32_t> marked_;
};

}  // namespace selvedge
