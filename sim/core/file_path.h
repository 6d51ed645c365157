#pragma once
// Paths that users and files name. No function here throws, because such a path may be anything: too long, a loop of
// links, in a folder that is closed to us. What cannot be looked at counts as missing. The throwing functions of
// std::filesystem are not used in the program (tests/style/check_text.py).
#include <filesystem>
#include <system_error>
#include <vector>

namespace selvedge::sim {

bool file_exists(const std::filesystem::path& path);  // of any kind: also a folder or a device
bool is_file(const std::filesystem::path& path);
bool is_folder(const std::filesystem::path& path);

// From the root folder. A relative path is relative to the working folder; as given if that is gone.
std::filesystem::path absolute_path(const std::filesystem::path& path);

// One name for each file, whatever its spelling: absolute, without links and dots. The file need not exist. If the file
// system cannot say, the absolute path without dots.
std::filesystem::path canonical_path(const std::filesystem::path& path);

// The file that is written when `path` is: the target of a link, also if that is missing. As given if the links do not
// end.
std::filesystem::path behind_links(const std::filesystem::path& path);

std::filesystem::path folder_of(const std::filesystem::path& path);  // "." of a name alone

// What a folder holds, in no order. On an error: what was read before it.
std::vector<std::filesystem::path> entries_of(const std::filesystem::path& folder, std::error_code& error);

}  // namespace selvedge::sim
