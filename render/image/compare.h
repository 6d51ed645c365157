#pragma once
// How far two pictures are apart. Software rendering gives the same bits on one machine, and on another CPU differs
// in a few pixels by a few steps: golden pictures are compared exactly first and within those limits after.
#include <cstddef>
#include <string>

#include "render/image/image.h"

namespace selvedge::render {

struct CompareOptions {
    int tolerance = 3;           // largest step of a channel, of 255, that rounding may explain
    double share_beyond = 1e-4;  // share of pixels that may be off by more
};

struct Comparison {
    bool has_same_size = false;
    std::size_t pixels = 0;     // of the larger extent in both directions
    std::size_t differing = 0;  // pixels that are not the same; those that only one picture has count
    std::size_t beyond = 0;     // pixels that differ by more than the tolerance
    int largest_step = 0;       // of 255

    bool is_exact() const { return has_same_size && differing == 0; }
    double share_differing() const { return pixels == 0 ? 0.0 : double(differing) / double(pixels); }
    double share_beyond() const { return pixels == 0 ? 0.0 : double(beyond) / double(pixels); }
};

Comparison compare(const Image& a, const Image& b, const CompareOptions& options = {});

// The golden rule: exact, or within the tolerance but for the allowed share.
bool is_alike(const Comparison& comparison, const CompareOptions& options = {});

// One line for people: "1.25 % of the pixels differ (0.30 % by more than 3/255, at most 87/255)".
std::string describe(const Comparison& comparison, const CompareOptions& options = {});

// `a` in pale grey, with the pixels that differ in red, the stronger the further apart; magenta where only one
// picture reaches. Empty when both are.
Image difference_picture(const Image& a, const Image& b);

}  // namespace selvedge::render
