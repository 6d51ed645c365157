#pragma once
// SHA-256 (FIPS 180-4) of texts and files, as 64 hexadecimal digits: the name of a content, as `sha256sum` prints it.
#include <filesystem>
#include <string>
#include <string_view>

namespace selvedge::sim {

std::string sha256(std::string_view content);

// Reads the file in parts. Throws InputError if it cannot be read, or is no regular file.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace selvedge::sim
