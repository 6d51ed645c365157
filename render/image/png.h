#pragma once
// Pictures as PNG files (libpng). Reading trusts nothing: size limits come before any memory is taken.
#include <filesystem>
#include <string>
#include <string_view>

#include "render/image/image.h"

namespace selvedge {

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

}  // namespace selvedge
