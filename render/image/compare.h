#pragma once
// Compares pictures for golden tests. Software rendering is byte-identical on one machine; on another CPU a few pixels
// differ by a few steps. So pictures are compared exactly first, then within these limits.
#include <cstddef>
#include <string>

#include "render/image/image.h"

namespace selvedge::render {

struct CompareOptions {
    int tolerance = 3;           // of 255, in any channel: differences up to this are taken as rounding
    double share_beyond = 1e-4;  // fraction of pixels that may differ by more
};

struct Comparison {
    bool has_same_size = false;
    std::size_t pixels = 0;     // larger width times larger height of the two
    std::size_t differing = 0;  // pixels that differ, or that only one picture has
    std::size_t beyond = 0;     // pixels that differ by more than the tolerance
    int largest_step = 0;       // of 255, in any channel

    bool is_exact() const { return has_same_size && differing == 0; }
    double share_differing() const { return pixels == 0 ? 0.0 : double(differing) / double(pixels); }
    double share_beyond() const { return pixels == 0 ? 0.0 : double(beyond) / double(pixels); }
};

Comparison compare(const Image& a, const Image& b, const CompareOptions& options = {});

// The golden tests' rule: exact, or of the same size with at most share_beyond of the pixels beyond the tolerance.
bool is_alike(const Comparison& comparison, const CompareOptions& options = {});

// One line of text: "1.25 % of the pixels differ (0.30 % by more than 3/255, at most 87/255)".
std::string describe(const Comparison& comparison, const CompareOptions& options = {});

// `a` in pale grey; pixels that differ in red, stronger for larger differences; magenta where only one picture has a
// pixel. Empty if both are empty.
Image difference_picture(const Image& a, const Image& b);

}  // namespace selvedge::render
