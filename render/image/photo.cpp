#include "render/image/photo.h"

#include <libexif/exif-data.h>
#include <turbojpeg.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/file.h"

namespace selvedge::render {
namespace {

constexpr std::string_view kPngSignature("\x89PNG\r\n\x1A\n", 8);
constexpr std::string_view kJpegSignature("\xFF\xD8\xFF", 3);
constexpr double kMetresPerInch = 0.0254;

std::uint32_t big_endian(std::string_view bytes, std::size_t at, std::size_t count) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count && at + i < bytes.size(); ++i) {
        value = value << 8U | static_cast<std::uint8_t>(bytes[at + i]);
    }
    return value;
}

std::optional<double> pixel_size_of(double per_metre) {
    const double per_inch = per_metre * kMetresPerInch;
    if (per_inch < kLeastScanResolution || per_inch > kMostScanResolution) return std::nullopt;
    return 1 / per_metre;
}

// The chunk pHYs (PNG 1.2, 4.2.4.2), which stands before the image data.
std::optional<double> png_pixel_size(std::string_view bytes) {
    std::size_t at = kPngSignature.size();
    while (at + 12 <= bytes.size()) {
        const std::size_t length = big_endian(bytes, at, 4);
        const std::string_view kind = bytes.substr(at + 4, 4);
        if (kind == "IDAT") return std::nullopt;
        if (kind == "pHYs" && length == 9) {
            const bool is_in_metres = big_endian(bytes, at + 16, 1) == 1;
            return is_in_metres ? pixel_size_of(big_endian(bytes, at + 8, 4)) : std::nullopt;
        }
        at += 12 + length;
    }
    return std::nullopt;
}

// The density in JFIF's segment (JFIF 1.02), which is the first.
std::optional<double> jpeg_pixel_size(std::string_view bytes) {
    if (bytes.substr(2, 2) != "\xFF\xE0" || bytes.substr(6, 4) != "JFIF") return std::nullopt;
    const std::uint32_t unit = big_endian(bytes, 13, 1), density = big_endian(bytes, 14, 2);
    if (unit == 1) return pixel_size_of(density / kMetresPerInch);
    if (unit == 2) return pixel_size_of(density * 100.0);
    return std::nullopt;
}

// 1 to 8; 1: upright.
int orientation_of(std::string_view bytes) {
    const auto* start = reinterpret_cast<const unsigned char*>(bytes.data());
    const std::size_t head = std::min<std::size_t>(bytes.size(), 1U << 20U);  // Exif is in one of the first segments
    const std::unique_ptr<ExifData, void (*)(ExifData*)> data(
        exif_data_new_from_data(start, static_cast<unsigned>(head)), [](ExifData* held) { exif_data_unref(held); });
    if (!data) return 1;
    const ExifEntry* entry = exif_content_get_entry(data->ifd[EXIF_IFD_0], EXIF_TAG_ORIENTATION);
    if (entry == nullptr || entry->format != EXIF_FORMAT_SHORT || entry->size < 2) return 1;
    const int value = exif_get_short(entry->data, exif_data_get_byte_order(data.get()));
    return value >= 1 && value <= 8 ? value : 1;
}

// Where the pixel (x, y) of the upright image is in the stored one, of that size.
std::pair<int, int> stored_place(int orientation, int x, int y, int width, int height) {
    const bool is_transposed = orientation >= 5;
    if (is_transposed) std::swap(x, y);
    const bool from_right = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool from_below = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    return {from_right ? width - 1 - x : x, from_below ? height - 1 - y : y};
}

Image upright(Image stored, int orientation) {
    if (orientation == 1) return stored;
    const int width = stored.width_px, height = stored.height_px;
    Image image(orientation >= 5 ? height : width, orientation >= 5 ? width : height);
    for (int y = 0; y < image.height_px; ++y) {
        for (int x = 0; x < image.width_px; ++x) {
            const auto [from_x, from_y] = stored_place(orientation, x, y, width, height);
            image.at(x, y) = stored.at(from_x, from_y);
        }
    }
    return image;
}

using JpegHandle = std::unique_ptr<void, int (*)(tjhandle)>;

Image decode_jpeg(std::string_view bytes, const std::string& name) {
    const JpegHandle jpeg(tjInitDecompress(), tjDestroy);
    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    const auto fail = [&](const std::string& what) {
        throw sim::InputError(name, "", what + ": " + tjGetErrorStr2(jpeg.get()));
    };
    int width = 0, height = 0, subsampling = 0, colours = 0;
    const int read = tjDecompressHeader3(jpeg.get(), data, bytes.size(), &width, &height, &subsampling, &colours);
    if (read != 0 || width <= 0 || height <= 0) fail("not a whole JPEG picture");
    check_image_size(width, height, name);
    if (colours == TJCS_CMYK || colours == TJCS_YCCK)
        throw sim::InputError(name, "", "a JPEG picture in printing colours (CMYK): save it in RGB");
    Image image(width, height);
    auto* pixels = reinterpret_cast<unsigned char*>(image.pixels.data());
    const int done = tjDecompress2(jpeg.get(), data, bytes.size(), pixels, width, 0, height, TJPF_RGBA,
                                   TJFLAG_ACCURATEDCT | TJFLAG_LIMITSCANS);
    if (done != 0 && tjGetErrorCode(jpeg.get()) == TJERR_FATAL) fail("damaged JPEG picture");
    return image;
}

}  // namespace

bool is_photo(std::string_view bytes) {
    return bytes.starts_with(kPngSignature) || bytes.starts_with(kJpegSignature);
}

Photo decode_photo(std::string_view bytes, const std::string& name) {
    if (bytes.starts_with(kPngSignature)) return {decode_png(bytes, name), png_pixel_size(bytes)};
    if (!bytes.starts_with(kJpegSignature)) throw sim::InputError(name, "", "neither a PNG nor a JPEG picture");
    return {upright(decode_jpeg(bytes, name), orientation_of(bytes)), jpeg_pixel_size(bytes)};
}

Photo read_photo(const std::filesystem::path& path) {
    return decode_photo(sim::read_file(path, kMaxImageFileBytes), path.string());
}

std::string encode_jpeg(const Image& image, int quality) {
    SELVEDGE_ASSERT(image.width_px > 0 && image.height_px > 0 && quality >= 1 && quality <= 100);
    const JpegHandle jpeg(tjInitCompress(), tjDestroy);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    const auto* pixels = reinterpret_cast<const unsigned char*>(image.pixels.data());
    const int failed = tjCompress2(jpeg.get(), pixels, image.width_px, 0, image.height_px, TJPF_RGBA, &bytes, &size,
                                   TJSAMP_444, quality, TJFLAG_ACCURATEDCT);
    const std::unique_ptr<unsigned char, void (*)(unsigned char*)> owned(bytes, tjFree);
    SELVEDGE_ASSERT(failed == 0);
    return {reinterpret_cast<const char*>(bytes), size};
}

namespace {

Image halved(const Image& image) {
    const auto power = [](double value) { return std::pow(value, 2.2); };
    std::array<double, 256> linear{};
    for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = power(double(i) / 255);
    Image half(std::max(1, image.width_px / 2), std::max(1, image.height_px / 2));
    for (int y = 0; y < half.height_px; ++y) {
        for (int x = 0; x < half.width_px; ++x) {
            std::array<double, 4> sum{};
            for (const auto& [dx, dy] : {std::pair(0, 0), std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)}) {
                const Rgba8& from =
                    image.at(std::min(2 * x + dx, image.width_px - 1), std::min(2 * y + dy, image.height_px - 1));
                for (std::size_t i = 0; i < 3; ++i) sum[i] += linear[from[i]] / 4;
                sum[3] += from[3] / 4.0;
            }
            Rgba8& to = half.at(x, y);
            for (std::size_t i = 0; i < 3; ++i)
                to[i] = static_cast<std::uint8_t>(std::lround(255 * std::pow(sum[i], 1 / 2.2)));
            to[3] = static_cast<std::uint8_t>(std::lround(sum[3]));
        }
    }
    return half;
}

}  // namespace

Image reduced(Image image, int most_side) {
    SELVEDGE_ASSERT(most_side > 0);
    while (std::max(image.width_px, image.height_px) > most_side) image = halved(image);
    return image;
}

}  // namespace selvedge::render
