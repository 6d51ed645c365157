#include "render/image/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "sim/core/assert.h"

namespace selvedge::render {
namespace {

constexpr int kSpace = 3;  // px, between words
constexpr int kGap = 1;    // px, between letters

struct Letter {
    Glyph glyph{};
    int first = 0;  // column
    int width = 0;  // px
};

bool is_continuation_byte(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

// Digits keep the full width, so that columns of numbers are aligned.
Letter find_letter(char code) {
    Letter letter{.glyph = find_glyph(code), .first = 0, .width = kGlyphWidth};
    if (code == ' ') return {.glyph = letter.glyph, .first = 0, .width = kSpace};
    if (std::isdigit(static_cast<unsigned char>(code)) != 0) return letter;
    unsigned columns = 0;
    for (const std::uint8_t row : letter.glyph) columns |= row;
    while (letter.width > 1 && (columns & 1U) == 0) columns >>= 1U, --letter.width;
    while (letter.first < letter.width - 1 && (columns >> (letter.width - 1 - letter.first) & 1U) == 0) ++letter.first;
    letter.width -= letter.first;
    return letter;
}

bool is_set(const Letter& letter, int column, int row) {
    if (column < 0 || column >= kGlyphWidth || row < 0 || row >= kGlyphHeight) return false;
    return (letter.glyph[static_cast<std::size_t>(row)] >> (kGlyphWidth - 1 - column) & 1U) != 0;
}

// Ink coverage of the pixel (x, y), 0..1; `scale` is in picture pixels per font pixel. Where two font pixels of a
// stroke touch only at their corners, the steps between them are filled to a slant.
float ink_at(const Letter& letter, int x, int y, int scale) {
    const int column = x / scale, row = y / scale;
    if (is_set(letter, column, row)) return 1;
    const float across = (float(x % scale) + 0.5F) / float(scale), down = (float(y % scale) + 0.5F) / float(scale);
    for (const int side : {-1, 1}) {
        for (const int end : {-1, 1}) {
            if (!is_set(letter, column + side, row) || !is_set(letter, column, row + end)) continue;
            if (is_set(letter, column + side, row + end)) continue;
            const float to_side = side > 0 ? 1 - across : across, to_end = end > 0 ? 1 - down : down;
            return std::clamp((0.5F - to_side - to_end) * float(scale) + 0.5F, 0.0F, 1.0F);
        }
    }
    return 0;
}

void blend(Rgba8& under, const Rgba8& colour, float share) {
    const float over = share * float(colour[3]) / 255;
    const float below = float(under[3]) / 255 * (1 - over);
    const float all = over + below;
    if (all <= 0) return;
    for (std::size_t i = 0; i < 3; ++i) {
        under[i] = static_cast<std::uint8_t>(std::lround((float(colour[i]) * over + float(under[i]) * below) / all));
    }
    under[3] = static_cast<std::uint8_t>(std::lround(255 * all));
}

void draw_letter(Image& image, int left, int top, const Letter& letter, const TextOptions& options) {
    for (int y = 0; y < kGlyphHeight * options.scale; ++y) {
        for (int x = 0; x < letter.width * options.scale; ++x) {
            const float ink = ink_at(letter, x + letter.first * options.scale, y, options.scale);
            if (ink > 0 && image.contains(left + x, top + y)) blend(image.at(left + x, top + y), options.colour, ink);
        }
    }
}

}  // namespace

void fill_box(Image& image, const PixelBox& box, const Rgba8& colour) {
    fill_rounded(image, box, 0, colour);
}

void fill_rounded(Image& image, const PixelBox& box, int radius, const Rgba8& colour) {
    for (int y = std::max(box.top, 0); y < std::min(box.top + box.height, image.height_px); ++y) {
        for (int x = std::max(box.left, 0); x < std::min(box.left + box.width, image.width_px); ++x) {
            const float inside_x = float(std::min(x - box.left, box.left + box.width - 1 - x)) + 0.5F;
            const float inside_y = float(std::min(y - box.top, box.top + box.height - 1 - y)) + 0.5F;
            const float off =
                std::hypot(std::max(float(radius) - inside_x, 0.0F), std::max(float(radius) - inside_y, 0.0F));
            const float inside = radius > 0 ? std::clamp(float(radius) + 0.5F - off, 0.0F, 1.0F) : 1.0F;
            blend(image.at(x, y), colour, inside);
        }
    }
}

void blend_ink(Image& image, const PixelBox& box, std::span<const std::uint8_t> ink, const Rgba8& colour) {
    SELVEDGE_ASSERT(ink.size() == static_cast<std::size_t>(box.width) * static_cast<std::size_t>(box.height));
    for (int y = 0; y < box.height; ++y) {
        for (int x = 0; x < box.width; ++x) {
            const std::uint8_t covered = ink[static_cast<std::size_t>(y * box.width + x)];
            if (covered == 0 || !image.contains(box.left + x, box.top + y)) continue;
            blend(image.at(box.left + x, box.top + y), colour, float(covered) / 255);
        }
    }
}

int text_width(std::string_view text) {
    int width = 0;
    for (const char code : text) {
        if (!is_continuation_byte(code)) width += find_letter(code).width + kGap;
    }
    return std::max(width - kGap, 0);
}

void draw_text(Image& image, int left, int top, std::string_view text, const TextOptions& options) {
    for (const char code : text) {
        if (is_continuation_byte(code)) continue;
        const Letter letter = find_letter(code);
        draw_letter(image, left, top, letter, options);
        left += (letter.width + kGap) * options.scale;
    }
}

namespace {

constexpr int kFirst = 32, kLast = 126;
constexpr int kPerBand = 16;

// Sixteen glyphs per band, nine rows per glyph.
constexpr std::string_view kSheet[] = {
    //       !     "     #     $     %     &     '     (     )     *     +     ,     -     .     /
    "..... ..#.. .#.#. .#.#. ..#.. ##... .##.. ..#.. ...#. .#... ..... ..... ..... ..... ..... ....#",
    "..... ..#.. .#.#. .#.#. .#### ##..# #..#. ..#.. ..#.. ..#.. ..#.. ..#.. ..... ..... ..... ....#",
    "..... ..#.. .#.#. ##### #.#.. ...#. #.#.. ..#.. .#... ...#. #.#.# ..#.. ..... ..... ..... ...#.",
    "..... ..#.. ..... .#.#. .###. ..#.. .#... ..... .#... ...#. .###. ##### ..... .###. ..... ..#..",
    "..... ..#.. ..... ##### ..#.# .#... #.#.# ..... .#... ...#. #.#.# ..#.. ..... ..... ..... .#...",
    "..... ..... ..... .#.#. ####. #..## #..#. ..... ..#.. ..#.. ..#.. ..#.. .##.. ..... .##.. #....",
    "..... ..#.. ..... .#.#. ..#.. ...## .##.# ..... ...#. .#... ..... ..... .##.. ..... .##.. #....",
    "..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..#.. ..... ..... .....",
    "..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .#... ..... ..... .....",
    //  0     1     2     3     4     5     6     7     8     9     :     ;     <     =     >     ?
    "..#.. ..#.. .###. ##### ...#. ##### ..##. ##### .###. .###. ..... ..... ...#. ..... .#... .###.",
    ".#.#. .##.. #...# ...#. ..##. #.... .#... ....# #...# #...# .##.. .##.. ..#.. ..... ..#.. #...#",
    "#...# ..#.. ....# ..#.. .#.#. ####. #.... ...#. #...# #...# .##.. .##.. .#... ##### ...#. ....#",
    "#...# ..#.. ...#. ...#. #..#. ....# ####. ..#.. .###. .#### ..... ..... #.... ..... ....# ...#.",
    "#...# ..#.. ..#.. ....# ##### ....# #...# .#... #...# ....# ..... ..... .#... ##### ...#. ..#..",
    ".#.#. ..#.. .#... #...# ...#. #...# #...# .#... #...# ...#. .##.. .##.. ..#.. ..... ..#.. .....",
    "..#.. .###. ##### .###. ...#. .###. .###. .#... .###. .##.. .##.. .##.. ...#. ..... .#... ..#..",
    "..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..#.. ..... ..... ..... .....",
    "..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .#... ..... ..... ..... .....",
    //  @     A     B     C     D     E     F     G     H     I     J     K     L     M     N     O
    ".###. .###. ####. .###. ####. ##### ##### .###. #...# .###. ..### #...# #.... #...# #...# .###.",
    "#...# #...# #...# #...# #...# #.... #.... #...# #...# ..#.. ...#. #..#. #.... ##.## ##..# #...#",
    "#.### #...# #...# #.... #...# #.... #.... #.... #...# ..#.. ...#. #.#.. #.... #.#.# #.#.# #...#",
    "#.#.# ##### ####. #.... #...# ####. ####. #.### ##### ..#.. ...#. ##... #.... #.#.# #..## #...#",
    "#.### #...# #...# #.... #...# #.... #.... #...# #...# ..#.. ...#. #.#.. #.... #...# #...# #...#",
    "#.... #...# #...# #...# #...# #.... #.... #...# #...# ..#.. #..#. #..#. #.... #...# #...# #...#",
    ".#### #...# ####. .###. ####. ##### #.... .###. #...# .###. .##.. #...# ##### #...# #...# .###.",
    "..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .....",
    "..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .....",
    //  P     Q     R     S     T     U     V     W     X     Y     Z     [     \     ]     ^     _
    "####. .###. ####. .#### ##### #...# #...# #...# #...# #...# ##### .###. #.... .###. ..#.. .....",
    "#...# #...# #...# #.... ..#.. #...# #...# #...# #...# #...# ....# .#... #.... ...#. .#.#. .....",
    "#...# #...# #...# #.... ..#.. #...# #...# #...# .#.#. .#.#. ...#. .#... .#... ...#. #...# .....",
    "####. #...# ####. .###. ..#.. #...# #...# #.#.# ..#.. ..#.. ..#.. .#... ..#.. ...#. ..... .....",
    "#.... #.#.# #.#.. ....# ..#.. #...# #...# #.#.# .#.#. ..#.. .#... .#... ...#. ...#. ..... .....",
    "#.... #..#. #..#. ....# ..#.. #...# .#.#. #.#.# #...# ..#.. #.... .#... ....# ...#. ..... .....",
    "#.... .##.# #...# ####. ..#.. .###. ..#.. .#.#. #...# ..#.. ##### .###. ....# .###. ..... .....",
    "..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... #####",
    "..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .....",
    //  `     a     b     c     d     e     f     g     h     i     j     k     l     m     n     o
    ".#... ..... #.... ..... ....# ..... ..##. ..... #.... ..#.. ...#. #.... .##.. ..... ..... .....",
    "..#.. ..... #.... ..... ....# ..... .#... ..... #.... ..... ..... #.... ..#.. ..... ..... .....",
    "...#. .###. #.##. .###. .##.# .###. .#... .#### #.##. .##.. ..##. #..#. ..#.. ##.#. #.##. .###.",
    "..... ....# ##..# #.... #..## #...# ####. #...# ##..# ..#.. ...#. #.#.. ..#.. #.#.# ##..# #...#",
    "..... .#### #...# #.... #...# ##### .#... #...# #...# ..#.. ...#. ##... ..#.. #.#.# #...# #...#",
    "..... #...# #...# #...# #...# #.... .#... #...# #...# ..#.. ...#. #.#.. ..#.. #.#.# #...# #...#",
    "..... .#### ####. .###. .#### .###. .#... .#### #...# .###. ...#. #..#. .###. #.#.# #...# .###.",
    "..... ..... ..... ..... ..... ..... ..... ....# ..... ..... #..#. ..... ..... ..... ..... .....",
    "..... ..... ..... ..... ..... ..... ..... .###. ..... ..... .##.. ..... ..... ..... ..... .....",
    //  p     q     r     s     t     u     v     w     x     y     z     {     |     }     ~
    "..... ..... ..... ..... .#... ..... ..... ..... ..... ..... ..... ...#. ..#.. .#... .....",
    "..... ..... ..... ..... .#... ..... ..... ..... ..... ..... ..... ..#.. ..#.. ..#.. .....",
    "####. .#### #.##. .#### ####. #...# #...# #...# #...# #...# ##### ..#.. ..#.. ..#.. .#...",
    "#...# #...# ##..# #.... .#... #...# #...# #...# .#.#. #...# ...#. .#... ..#.. ...#. #.#.#",
    "#...# #...# #.... .###. .#... #...# #...# #.#.# ..#.. #...# ..#.. ..#.. ..#.. ..#.. ...#.",
    "#...# #...# #.... ....# .#..# #..## .#.#. #.#.# .#.#. #...# .#... ..#.. ..#.. ..#.. .....",
    "####. .#### #.... ####. ..##. .##.# ..#.. .#.#. #...# .#### ##### ...#. ..#.. .#... .....",
    "#.... ....# ..... ..... ..... ..... ..... ..... ..... ....# ..... ..... ..... ..... .....",
    "#.... ....# ..... ..... ..... ..... ..... ..... ..... .###. ..... ..... ..... ..... .....",
};

}  // namespace

Glyph find_glyph(char letter) {
    const int code = static_cast<unsigned char>(letter);
    const int index = (code >= kFirst && code <= kLast ? code : '?') - kFirst;
    const int band = index / kPerBand, place = index % kPerBand;
    Glyph glyph{};
    for (int row = 0; row < kGlyphHeight; ++row) {
        const std::string_view line = kSheet[band * kGlyphHeight + row];
        for (int column = 0; column < kGlyphWidth; ++column) {
            const bool is_set = line[static_cast<std::size_t>(place * (kGlyphWidth + 1) + column)] == '#';
            auto& bits = glyph[static_cast<std::size_t>(row)];
            bits = static_cast<std::uint8_t>(bits << 1 | (is_set ? 1 : 0));
        }
    }
    return glyph;
}

}  // namespace selvedge::render
