#include "tests/golden/blocks.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace selvedge::test {
namespace {

using Mean = std::array<double, 4>;

// Mean of the block with the upper left corner (left, top); blocks at the picture's border may be smaller.
Mean mean_colour(const render::Image& image, int left, int top, int side_px) {
    Mean sum{};
    int count = 0;
    for (int y = top; y < std::min(top + side_px, image.height_px); ++y) {
        for (int x = left; x < std::min(left + side_px, image.width_px); ++x, ++count) {
            for (std::size_t channel = 0; channel < sum.size(); ++channel) sum[channel] += image.at(x, y)[channel];
        }
    }
    for (double& channel : sum) channel /= count;
    return sum;
}

double largest_step(const Mean& a, const Mean& b) {
    double step = 0;
    for (std::size_t i = 0; i < a.size(); ++i) step = std::max(step, std::abs(a[i] - b[i]));
    return step;
}

}  // namespace

BlockComparison compare_blocks(const render::Image& a, const render::Image& b, const BlockOptions& options) {
    BlockComparison result;
    result.has_same_size = a.width_px == b.width_px && a.height_px == b.height_px;
    if (!result.has_same_size) return result;
    for (int top = 0; top < a.height_px; top += options.side_px) {
        for (int left = 0; left < a.width_px; left += options.side_px) {
            const double step =
                largest_step(mean_colour(a, left, top, options.side_px), mean_colour(b, left, top, options.side_px));
            ++result.blocks;
            result.beyond += step > options.tolerance ? 1 : 0;
            result.largest_step = std::max(result.largest_step, step);
        }
    }
    return result;
}

bool is_alike(const BlockComparison& comparison, const BlockOptions& options) {
    return comparison.has_same_size && comparison.share_beyond() <= options.share_beyond;
}

std::string describe(const BlockComparison& comparison, const BlockOptions& options) {
    if (!comparison.has_same_size) return "the sizes differ";
    std::ostringstream text;
    text.precision(3);
    text << 100 * comparison.share_beyond() << " % of the blocks differ by more than " << options.tolerance
         << "/255, at most " << comparison.largest_step << "/255";
    return text.str();
}

}  // namespace selvedge::test
