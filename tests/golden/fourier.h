#pragma once
// Fourier transform of a square picture, and the strongest slow wave in it.
#include <complex>
#include <string>
#include <vector>

#include "render/image/image.h"

namespace selvedge::test {

// values: in rows, side x side; side is a power of two. Returns the coefficients; the indices are the numbers of waves
// along x and y, with negative numbers counted from the end. (0, 0) is the mean.
std::vector<std::complex<double>> fourier(const std::vector<double>& values, int side);

// The largest amplitude among waves with at most `most` and at least 2 periods per picture. A Hann window fades the
// picture towards its borders, so that it need not be periodic.
double greatest_slow_wave(const std::vector<double>& values, int side, int most);

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

}  // namespace selvedge::test
