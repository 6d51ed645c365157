#pragma once
// Reading whole files within a limit, and writing them so that a kill at any moment leaves the old or the new one.
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace selvedge::sim {

// Throws InputError when the file cannot be read, is no regular file, or is larger than max_bytes.
std::string read_file(const std::filesystem::path& path, std::size_t max_bytes);

// Writes a temporary file beside it, syncs, renames, syncs the folder; a link stays, and what it points to is written.
// Throws InputError when it cannot.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

// Files compiled into the program (cmake/SelvedgeEmbed.cmake), so that it runs from any folder.

struct EmbeddedFile {
    std::string_view name;  // path from the source root
    std::string_view text;
};

}  // namespace selvedge::sim
