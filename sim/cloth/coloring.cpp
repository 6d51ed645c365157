#include "sim/cloth/coloring.h"

namespace selvedge {

void BlockColoring::start(std::size_t vertices) {
    used_.assign(vertices, 0);
    colors_.clear();
    counts_.clear();
    alone_ = 0;
}

const std::vector<std::uint32_t>& BlockColoring::assign() {
    blocks_ = 0;
    next_.clear();
    for (const std::uint32_t count : counts_) {
        next_.push_back(static_cast<std::uint32_t>(blocks_ * kBlock));
        blocks_ += (count + kBlock - 1) / kBlock;
    }
    lanes_.clear();
    for (const std::uint32_t color : colors_) lanes_.push_back(next_[color]++);
    return lanes_;
}

}  // namespace selvedge
