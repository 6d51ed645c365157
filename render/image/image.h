#pragma once
// A picture in memory, which the renderer returns and golden tests compare, and reading and writing it as a PNG file.
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

// PNG files (libpng). The reader does not trust its input: it checks the size limits before it allocates memory.

inline constexpr int kMaxImageSide = 16384;  // px
inline constexpr long kMaxImagePixels = 100L * 1000 * 1000;

// Throws InputError if the file cannot be read, is damaged or truncated, or exceeds the limits.
Image read_png(const std::filesystem::path& path);

// `name`: the file's name in error messages.
Image decode_png(std::string_view bytes, const std::string& name);

// Equal images give equal bytes. Pre: the image is not empty.
std::string encode_png(const Image& image);

// Atomic: if the process is killed, the file is the old or the new one. Throws InputError if it cannot be written.
void write_png(const std::filesystem::path& path, const Image& image);

}  // namespace selvedge::render
