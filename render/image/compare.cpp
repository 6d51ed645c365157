#include "render/image/compare.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace selvedge::render {
namespace {

int largest_step(const Rgba8& a, const Rgba8& b) {
    int step = 0;
    for (std::size_t i = 0; i < 4; ++i) step = std::max(step, std::abs(int(a[i]) - int(b[i])));
    return step;
}

std::uint8_t to_byte(double value) {
    return static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0));
}

Rgba8 paled(const Rgba8& pixel) {
    const double grey = 0.3 * pixel[0] + 0.59 * pixel[1] + 0.11 * pixel[2];
    const std::uint8_t pale = to_byte(170 + grey / 3);
    return {pale, pale, pale, 255};
}

// Even a difference of one step must be visible.
Rgba8 marked(int step) {
    const std::uint8_t rest = to_byte(150.0 * (1.0 - std::min(1.0, step / 32.0)));
    return {230, rest, rest, 255};
}

}  // namespace

Comparison compare(const Image& a, const Image& b, const CompareOptions& options) {
    const int width = std::max(a.width_px, b.width_px);
    const int height = std::max(a.height_px, b.height_px);
    Comparison result;
    result.has_same_size = a.width_px == b.width_px && a.height_px == b.height_px;
    result.pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const bool in_both = a.contains(x, y) && b.contains(x, y);
            const int step = in_both ? largest_step(a.at(x, y), b.at(x, y)) : 255;
            result.differing += step > 0 ? 1 : 0;
            result.beyond += step > options.tolerance ? 1 : 0;
            result.largest_step = std::max(result.largest_step, step);
        }
    }
    return result;
}

bool is_alike(const Comparison& comparison, const CompareOptions& options) {
    if (comparison.is_exact()) return true;
    return comparison.has_same_size && comparison.share_beyond() <= options.share_beyond;
}

std::string describe(const Comparison& comparison, const CompareOptions& options) {
    if (comparison.is_exact()) return "the pictures are the same";
    std::ostringstream text;
    text.precision(3);
    if (!comparison.has_same_size) text << "the sizes differ; ";
    text << 100 * comparison.share_differing() << " % of the pixels differ (" << 100 * comparison.share_beyond()
         << " % by more than " << options.tolerance << "/255, at most " << comparison.largest_step << "/255)";
    return text.str();
}

Image difference_picture(const Image& a, const Image& b) {
    Image result(std::max(a.width_px, b.width_px), std::max(a.height_px, b.height_px));
    for (int y = 0; y < result.height_px; ++y) {
        for (int x = 0; x < result.width_px; ++x) {
            if (!a.contains(x, y) || !b.contains(x, y)) {
                result.at(x, y) = {255, 0, 255, 255};
                continue;
            }
            const int step = largest_step(a.at(x, y), b.at(x, y));
            result.at(x, y) = step == 0 ? paled(a.at(x, y)) : marked(step);
        }
    }
    return result;
}

}  // namespace selvedge::render
