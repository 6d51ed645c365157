#pragma once
// Text and boxes on a picture, in whole pixels, and the built-in bitmap font.
#include <cstdint>
#include <span>
#include <string_view>

#include "render/image/image.h"

namespace selvedge::render {

struct PixelBox {
    int left = 0;
    int top = 0;
    int width = 0;
    int height = 0;
};

// Blends the colour over the picture by its alpha. Parts outside the picture are clipped.
void fill_box(Image& image, const PixelBox& box, const Rgba8& colour);

// The same with corners rounded by `radius` px.
void fill_rounded(Image& image, const PixelBox& box, int radius, const Rgba8& colour);

// The same where there is ink: one byte per pixel of the box, row by row, 255 where the colour covers it wholly.
void blend_ink(Image& image, const PixelBox& box, std::span<const std::uint8_t> ink, const Rgba8& colour);

struct TextOptions {
    int scale = 1;  // picture pixels per font pixel
    Rgba8 colour{0x2C, 0x2C, 0x30, 255};
};

// Width in px at scale 1. Letters have different widths, digits the same. A UTF-8 character counts as one letter.
int text_width(std::string_view text);

// `left`, `top`: upper left of the first capital letter. At scale 2 or more, steps of slanted strokes are smoothed.
void draw_text(Image& image, int left, int top, std::string_view text, const TextOptions& options = {});

// The bitmap font of pictures for which no font of the system is given (render/image/outline_font.h). It is part of the
// program, so that these do not depend on the machine.
inline constexpr int kGlyphWidth = 5;   // px, at most
inline constexpr int kGlyphHeight = 9;  // px; the lowest two rows are below the baseline

// Rows from the top; bit 4 is the leftmost pixel. Characters outside ASCII 32..126 look like a question mark.
using Glyph = std::array<std::uint8_t, kGlyphHeight>;
Glyph find_glyph(char letter);

}  // namespace selvedge::render
