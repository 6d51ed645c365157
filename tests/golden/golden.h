#pragma once
// Compares results with the golden references in tests/golden/reference. If a picture fails, NAME.out.png and
// NAME.diff.png are written to the test's working directory. How to renew references: tests/golden/README.md.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "render/image/image.h"

namespace selvedge::test {

// Path of a reference; `file` includes the extension.
std::filesystem::path reference_path(const std::string& file);

// Whether SELVEDGE_RENEW_GOLDENS, a comma-separated list of names, contains this name.
bool is_to_be_renewed(const std::string& name);

// Fails if the reference is missing or the pictures are not alike (render/image/image.h). If SELVEDGE_RENEW_GOLDENS
// contains the name, writes the picture as the new reference instead.
testing::AssertionResult matches_golden(const render::Image& image, const std::string& name);

// The same with the rule for pictures of a drape, see BlockOptions.
testing::AssertionResult matches_golden_by_blocks(const render::Image& image, const std::string& name);

// Compares pictures of a drape. A drape amplifies rounding differences between CPUs into different small folds, so its
// pictures are compared by the mean colours of blocks, and a few blocks may differ. The limits lie between the effect
// of some 10 nm of the mannequin's height and the effect of faults (tests/golden/README.md).

struct BlockOptions {
    int side_px = 16;
    double tolerance = 30;       // of 255: difference of a block's mean in any channel
    double share_beyond = 0.05;  // fraction of blocks that may differ by more
};

struct BlockComparison {
    bool has_same_size = false;
    int blocks = 0;
    int beyond = 0;           // blocks that differ by more than the tolerance
    double largest_step = 0;  // of 255

    double share_beyond() const { return blocks == 0 ? 0.0 : double(beyond) / double(blocks); }
};

// If the sizes differ, only has_same_size is set.
BlockComparison compare_blocks(const render::Image& a, const render::Image& b, const BlockOptions& options = {});

bool is_alike(const BlockComparison& comparison, const BlockOptions& options = {});

// One line of text: "5.1 % of the blocks differ by more than 12/255, at most 43/255".
std::string describe(const BlockComparison& comparison, const BlockOptions& options = {});

// The stored reference. Throws InputError if it is missing.
render::Image read_reference(const std::string& name);

}  // namespace selvedge::test
