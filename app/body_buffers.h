#pragma once
// The files beside a body's file that are read with it: the buffers of a .gltf, which hold its numbers.
#include <filesystem>
#include <vector>

namespace selvedge::app {

// Those that are there, by each spelling that the file's reader may take: "my%20body.bin" is "my body.bin" too. None of
// other formats, or if the file cannot be read.
std::vector<std::filesystem::path> buffers_beside(const std::filesystem::path& body);

}  // namespace selvedge::app
