#pragma once
// How far two pictures of a drape are apart. A drape amplifies the last bits in which CPUs differ into other small
// folds, so its pictures are compared by the mean colours of blocks, and a few blocks may differ. The limits lie
// between what some 10 nm of the mannequin's height change and what faults do (tests/golden/README.md).
#include <string>

#include "render/image/image.h"

namespace selvedge::test {

struct BlockOptions {
    int side_px = 16;
    double tolerance = 30;       // of 255, of a block's mean in any channel
    double share_beyond = 0.05;  // share of blocks that may be off by more
};

struct BlockComparison {
    bool has_same_size = false;
    int blocks = 0;
    int beyond = 0;           // blocks that differ by more than the tolerance
    double largest_step = 0;  // of 255

    double share_beyond() const { return blocks == 0 ? 0.0 : double(beyond) / double(blocks); }
};

// Of pictures of unlike size nothing but that is told.
BlockComparison compare_blocks(const render::Image& a, const render::Image& b, const BlockOptions& options = {});

bool is_alike(const BlockComparison& comparison, const BlockOptions& options = {});

// One line for people: "5.1 % of the blocks differ by more than 12/255, at most 43/255".
std::string describe(const BlockComparison& comparison, const BlockOptions& options = {});

}  // namespace selvedge::test
