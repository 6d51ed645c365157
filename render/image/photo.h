#pragma once
// Reads photos and scans: PNG and JPEG files, turned as the camera was held (Exif 2.32, tag Orientation), with the true
// size of a pixel if a scanner wrote it.
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "render/image/image.h"

namespace selvedge::render {

struct Photo {
    Image image;
    // m, side of a pixel by the file's resolution (PNG pHYs, JFIF density); none: the file states none, or one below
    // kLeastScanResolution, which programs write without having measured it.
    std::optional<double> pixel_size{};
};

inline constexpr double kLeastScanResolution = 100;    // px per inch; cameras and screens write 72 and 96
inline constexpr double kMostScanResolution = 10'000;  // px per inch

// By the first bytes.
bool is_photo(std::string_view bytes);

// Throws InputError if the file is neither PNG nor JPEG, is damaged, or exceeds the limits of render/image/image.h.
Photo decode_photo(std::string_view bytes, const std::string& name);
Photo read_photo(const std::filesystem::path& path);

// A JPEG with neither orientation nor resolution. quality: 1 to 100. Pre: the image is not empty.
std::string encode_jpeg(const Image& image, int quality);

// Half as wide and high, each pixel the mean of four in linear light, until no side is longer. Pre: most_side > 0.
Image reduced(Image image, int most_side);

}  // namespace selvedge::render
