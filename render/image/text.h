#pragma once
// Words and boxes on a picture, in whole pixels.
#include <string_view>

#include "render/image/image.h"

namespace selvedge {

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

}  // namespace selvedge
