#pragma once
// A picture in memory: what the renderer hands over, what PNG files hold, what golden tests compare.
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/assert.h"

namespace selvedge::render {

using Rgba8 = std::array<std::uint8_t, 4>;  // sRGB, straight (not premultiplied) alpha

struct Image {
    int width_px = 0;
    int height_px = 0;
    std::vector<Rgba8> pixels;  // row by row from the top left; width_px * height_px of them

    Image() = default;
    Image(int width, int height, Rgba8 fill = {0, 0, 0, 255})
        : width_px(width),
          height_px(height),
          pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill) {}

    // Pre: 0 <= x < width_px, 0 <= y < height_px.
    Rgba8& at(int x, int y) { return pixels[index(x, y)]; }
    const Rgba8& at(int x, int y) const { return pixels[index(x, y)]; }
    bool contains(int x, int y) const { return x >= 0 && x < width_px && y >= 0 && y < height_px; }

    bool operator==(const Image&) const = default;

 private:
    std::size_t index(int x, int y) const {
        SELVEDGE_ASSERT(contains(x, y));
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) + static_cast<std::size_t>(x);
    }
};

// Pictures as PNG files (libpng). Reading trusts nothing: size limits come before any memory is taken.

inline constexpr int kMaxImageSide = 16384;  // px
inline constexpr long kMaxImagePixels = 100L * 1000 * 1000;

// Throws InputError when the file cannot be read, is damaged or cut short, or holds more pixels than the limits.
Image read_png(const std::filesystem::path& path);

// `name` stands for the file in errors.
Image decode_png(std::string_view bytes, const std::string& name);

// Same image, same bytes. Pre: the image is not empty.
std::string encode_png(const Image& image);

// Atomic: a kill leaves the old file or the new one. Throws InputError when it cannot be written.
void write_png(const std::filesystem::path& path, const Image& image);

}  // namespace selvedge::render
