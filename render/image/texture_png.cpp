#include "render/image/texture_png.h"

#include <png.h>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/core/assert.h"

namespace selvedge::render {

std::string encode_texture_png(const Image& image) {
    SELVEDGE_ASSERT(image.width_px > 0 && image.height_px > 0);
    std::vector<std::uint8_t> colours;
    colours.reserve(3 * image.pixels.size());
    for (const Rgba8& pixel : image.pixels) colours.insert(colours.end(), pixel.begin(), pixel.begin() + 3);
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width_px);
    png.height = static_cast<png_uint_32>(image.height_px);
    png.format = PNG_FORMAT_RGB;
    png.flags = PNG_IMAGE_FLAG_FAST;  // no filters, compression level 3
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::string bytes(size, '\0');
    const bool written = png_image_write_to_memory(&png, bytes.data(), &size, 0, colours.data(), 0, nullptr) != 0;
    png_image_free(&png);
    SELVEDGE_ASSERT(written);
    bytes.resize(size);
    return bytes;
}

}  // namespace selvedge::render
