#pragma once
// Reads whole files up to a size limit, and writes files atomically: if the program is killed at any moment, either the
// complete old file or the complete new file remains. Also the type of files that are embedded in the program.
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace selvedge::sim {

// Throws InputError if the file cannot be read, is not a regular file, or is larger than max_bytes.
std::string read_file(const std::filesystem::path& path, std::size_t max_bytes);

// Writes a temporary file in the same folder, calls fsync, renames it over `path`, and calls fsync on the folder. If
// `path` is a symbolic link, the link stays and its target is replaced. Throws InputError if the file cannot be
// written.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

// A file compiled into the program (cmake/SelvedgeEmbed.cmake), so that the program runs from any folder.

struct EmbeddedFile {
    std::string_view name;  // path relative to the source root
    std::string_view text;
};

}  // namespace selvedge::sim
