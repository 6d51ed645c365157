#pragma once
// A picture in memory, which the renderer returns and golden tests compare, and reading and writing it as a PNG file.
// Also the comparison of two pictures.
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

inline constexpr std::size_t kMaxImageFileBytes = std::size_t{512} << 20;

// Throws InputError if a picture of that size is over the limits. `name`: as below.
void check_image_size(long width_px, long height_px, const std::string& name);

// Throws InputError if the file cannot be read, is damaged or truncated, or exceeds the limits.
Image read_png(const std::filesystem::path& path);

// `name`: the file's name in error messages.
Image decode_png(std::string_view bytes, const std::string& name);

// Equal images give equal bytes. Pre: the image is not empty.
std::string encode_png(const Image& image);

// The colours of a picture of woven cloth, which repeats from yarn to yarn, without its alpha, unfiltered and lightly
// compressed: the filters of PNG, which suit smooth pictures, make such files larger, and most of the time to write
// them goes into the search for repeats. For a T-shirt's textures of 2048 pixels: in a quarter of the time of
// encode_png(), and a quarter smaller. Equal images give equal bytes. Pre: the image is not empty.
std::string encode_texture_png(const Image& image);

// Atomic: if the process is killed, the file is the old or the new one. Throws InputError if it cannot be written.
void write_png(const std::filesystem::path& path, const Image& image);

// Compares pictures for golden tests. Software rendering is byte-identical on one machine; on another CPU a few pixels
// differ by a few steps. So pictures are compared exactly first, then within these limits.

struct CompareOptions {
    int tolerance = 3;           // of 255, in any channel: differences up to this are taken as rounding
    double share_beyond = 1e-4;  // fraction of pixels that may differ by more
};

struct Comparison {
    bool has_same_size = false;
    std::size_t pixels = 0;     // larger width times larger height of the two
    std::size_t differing = 0;  // pixels that differ, or that only one picture has
    std::size_t beyond = 0;     // pixels that differ by more than the tolerance
    int largest_step = 0;       // of 255, in any channel

    bool is_exact() const { return has_same_size && differing == 0; }
    double share_differing() const { return pixels == 0 ? 0.0 : double(differing) / double(pixels); }
    double share_beyond() const { return pixels == 0 ? 0.0 : double(beyond) / double(pixels); }
};

Comparison compare(const Image& a, const Image& b, const CompareOptions& options = {});

// The golden tests' rule: exact, or of the same size with at most share_beyond of the pixels beyond the tolerance.
bool is_alike(const Comparison& comparison, const CompareOptions& options = {});

// One line of text: "1.25 % of the pixels differ (0.30 % by more than 3/255, at most 87/255)".
std::string describe(const Comparison& comparison, const CompareOptions& options = {});

// `a` in pale grey; pixels that differ in red, stronger for larger differences; magenta where only one picture has a
// pixel. Empty if both are empty.
Image difference_picture(const Image& a, const Image& b);

}  // namespace selvedge::render
