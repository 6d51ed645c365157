#include "batch/thumbnail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace selvedge::batch {
namespace {

// The pixels of the large picture that one of the small one covers along an axis: first and behind the last.
std::array<int, 2> covered(int small, int small_count, int count) {
    const int first = int(std::int64_t(small) * count / small_count);
    const int last = int(std::int64_t(small + 1) * count / small_count);
    return {first, std::max(first + 1, last)};
}

}  // namespace

render::Image shrunk(const render::Image& image, int most_px) {
    const int longest = std::max(image.width_px, image.height_px);
    if (longest <= most_px) return image;
    const auto scaled = [&](int side) { return std::max(1, int(std::int64_t(side) * most_px / longest)); };
    render::Image small(scaled(image.width_px), scaled(image.height_px));
    for (int y = 0; y < small.height_px; ++y) {
        const auto [top, bottom] = covered(y, small.height_px, image.height_px);
        for (int x = 0; x < small.width_px; ++x) {
            const auto [left, right] = covered(x, small.width_px, image.width_px);
            std::array<int, 4> sum{};
            for (int j = top; j < bottom; ++j) {
                for (int i = left; i < right; ++i) {
                    for (std::size_t c = 0; c < 4; ++c) sum[c] += image.at(i, j)[c];
                }
            }
            const int count = (bottom - top) * (right - left);
            for (std::size_t c = 0; c < 4; ++c) small.at(x, y)[c] = std::uint8_t((sum[c] + count / 2) / count);
        }
    }
    return small;
}

}  // namespace selvedge::batch
