#include "render/image/image.h"

#include <png.h>
#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "sim/core/error.h"
#include "sim/core/file.h"

namespace selvedge::render {
namespace {

// libpng's simplified interface: it reports errors in the struct and does not jump over destructors (longjmp).
class PngImage {
 public:
    PngImage() { image_.version = PNG_IMAGE_VERSION; }
    ~PngImage() { png_image_free(&image_); }
    PngImage(const PngImage&) = delete;
    PngImage& operator=(const PngImage&) = delete;

    png_image* get() { return &image_; }
    png_image* operator->() { return &image_; }

 private:
    png_image image_{};
};

}  // namespace

void check_image_size(long width_px, long height_px, const std::string& name) {
    if (width_px <= kMaxImageSide && height_px <= kMaxImageSide && width_px * height_px <= kMaxImagePixels) return;
    throw sim::InputError(
        name, "",
        "picture of " + std::to_string(width_px) + "x" + std::to_string(height_px) + " pixels is over the limit");
}

Image decode_png(std::string_view bytes, const std::string& name) {
    PngImage png;
    if (!png_image_begin_read_from_memory(png.get(), bytes.data(), bytes.size())) {
        throw sim::InputError(name, "", std::string("not a PNG picture: ") + png->message);
    }
    check_image_size(png->width, png->height, name);
    png->format = PNG_FORMAT_RGBA;
    Image image(static_cast<int>(png->width), static_cast<int>(png->height));
    if (!png_image_finish_read(png.get(), nullptr, image.pixels.data(), 0, nullptr)) {
        throw sim::InputError(name, "", std::string("damaged PNG picture: ") + png->message);
    }
    return image;
}

Image read_png(const std::filesystem::path& path) {
    return decode_png(sim::read_file(path, kMaxImageFileBytes), path.string());
}

std::string encode_png(const Image& image) {
    SELVEDGE_ASSERT(image.width_px > 0 && image.height_px > 0);
    PngImage png;
    png->width = static_cast<png_uint_32>(image.width_px);
    png->height = static_cast<png_uint_32>(image.height_px);
    png->format = PNG_FORMAT_RGBA;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(*png.get());
    std::string bytes(size, '\0');
    const bool written = png_image_write_to_memory(png.get(), bytes.data(), &size, 0, image.pixels.data(), 0, nullptr);
    SELVEDGE_ASSERT(written);
    bytes.resize(size);
    return bytes;
}

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

void write_png(const std::filesystem::path& path, const Image& image) {
    sim::write_file_atomically(path, encode_png(image));
}

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
