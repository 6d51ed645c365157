#pragma once
// The ending of a file's name, by which its format is told.
#include <filesystem>
#include <string>

namespace selvedge::sim {

// ".obj" of "Scan.OBJ": with its dot, in small letters of ASCII; empty if the name has none.
std::string lower_extension(const std::filesystem::path& path);

}  // namespace selvedge::sim
