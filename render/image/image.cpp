#include "render/image/image.h"

#include <png.h>

#include "sim/core/error.h"
#include "sim/core/file.h"

namespace selvedge::render {
namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{512} << 20;

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

bool is_too_large(const png_image& header) {
    return header.width > static_cast<unsigned>(kMaxImageSide) ||
           header.height > static_cast<unsigned>(kMaxImageSide) ||
           static_cast<long>(header.width) * static_cast<long>(header.height) > kMaxImagePixels;
}

}  // namespace

Image decode_png(std::string_view bytes, const std::string& name) {
    PngImage png;
    if (!png_image_begin_read_from_memory(png.get(), bytes.data(), bytes.size())) {
        throw sim::InputError(name, "", std::string("not a PNG picture: ") + png->message);
    }
    if (is_too_large(*png.get())) {
        throw sim::InputError(name, "",
                              "picture of " + std::to_string(png->width) + "x" + std::to_string(png->height) +
                                  " pixels is over the limit");
    }
    png->format = PNG_FORMAT_RGBA;
    Image image(static_cast<int>(png->width), static_cast<int>(png->height));
    if (!png_image_finish_read(png.get(), nullptr, image.pixels.data(), 0, nullptr)) {
        throw sim::InputError(name, "", std::string("damaged PNG picture: ") + png->message);
    }
    return image;
}

Image read_png(const std::filesystem::path& path) {
    return decode_png(sim::read_file(path, kMaxFileBytes), path.string());
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

void write_png(const std::filesystem::path& path, const Image& image) {
    sim::write_file_atomically(path, encode_png(image));
}

}  // namespace selvedge::render
