#pragma once
// Words and boxes on a picture, in whole pixels.
#include <cstdint>
#include <string_view>

#include "render/image/image.h"

namespace selvedge::render {

struct PixelBox {
    int left = 0;
    int top = 0;
    int width = 0;
    int height = 0;
};

// Lays the colour over what is there, by its alpha. What lies outside the picture is left out.
void fill_box(Image& image, const PixelBox& box, const Rgba8& colour);

// The same with corners rounded by `radius` px.
void fill_rounded(Image& image, const PixelBox& box, int radius, const Rgba8& colour);

struct TextOptions {
    int scale = 1;  // px of the picture for one of the letters
    Rgba8 colour{0x2C, 0x2C, 0x30, 255};
};

// px at scale 1: letters are as wide as they are drawn, figures all alike. UTF-8 beyond ASCII counts one letter each.
int text_width(std::string_view text);

// `left`, `top`: of the first capital. Steps of slanted strokes are cut where the scale is two or more.
void draw_text(Image& image, int left, int top, std::string_view text, const TextOptions& options = {});

// The letters of legends, as pixels: drawn for this program, so that a picture's bits hang on no font of the machine.
inline constexpr int kGlyphWidth = 5;   // px, at most
inline constexpr int kGlyphHeight = 9;  // px, the lowest two below the line
inline constexpr int kCapitalHeight = 7;

// Rows from the top; bit 4 is the leftmost pixel. What is not in ASCII 32..126 looks like a question mark.
using Glyph = std::array<std::uint8_t, kGlyphHeight>;
Glyph find_glyph(char letter);

}  // namespace selvedge::render
