#include "render/level_legend.h"

#include <algorithm>
#include <array>

#include "render/renderer.h"

namespace selvedge {
namespace {

// Digits 0..7, three pixels wide and five high: one row in three bits, from the top.
constexpr std::array<std::array<unsigned, 5>, kLevelColours> kDigits{{{7, 5, 5, 5, 7},
                                                                      {2, 6, 2, 2, 7},
                                                                      {7, 1, 7, 4, 7},
                                                                      {7, 1, 7, 1, 7},
                                                                      {5, 5, 7, 1, 1},
                                                                      {7, 4, 7, 1, 7},
                                                                      {7, 4, 7, 5, 7},
                                                                      {7, 1, 2, 2, 2}}};

struct Box {
    int left = 0;
    int top = 0;
    int width = 0;
    int height = 0;
};

void fill(Image& image, const Box& box, const Rgb8& colour) {
    for (int y = box.top; y < box.top + box.height; ++y) {
        for (int x = box.left; x < box.left + box.width; ++x) {
            image.at(x, y) = {colour[0], colour[1], colour[2], 255};
        }
    }
}

void draw_digit(Image& image, int digit, const Box& box) {
    const Rgb8 ink{0x3A, 0x3A, 0x3E};
    const int dot = box.width / 3;
    for (int row = 0; row < 5; ++row) {
        for (int column = 0; column < 3; ++column) {
            const bool is_set =
                kDigits[static_cast<std::size_t>(digit)][static_cast<std::size_t>(row)] >> (2 - column) & 1U;
            if (is_set) fill(image, {box.left + column * dot, box.top + row * dot, dot, dot}, ink);
        }
    }
}

int highest_level(const PlainMesh& mesh) {
    const auto highest = std::max_element(mesh.level.begin(), mesh.level.end());
    return highest == mesh.level.end() ? 0 : std::min<int>(*highest, kLevelColours - 1);
}

}  // namespace

void draw_level_legend(Image& image, const PlainMesh& mesh) {
    const int unit = std::max(1, std::min(image.width_px, image.height_px) / 512);
    const int swatch = 14 * unit, gap = 5 * unit, edge = 16 * unit;
    const int levels = highest_level(mesh) + 1;
    const int height = levels * (swatch + gap);
    if (image.height_px < height + 2 * edge || image.width_px < 6 * swatch) return;
    for (int level = 0; level < levels; ++level) {
        const int top = image.height_px - edge - (level + 1) * swatch - level * gap;
        fill(image, {edge, top, swatch, swatch}, level_colour(level));
        draw_digit(image, level, {edge + swatch + gap, top + 2 * unit, 6 * unit, 10 * unit});
    }
}

}  // namespace selvedge
