#pragma once
// The container of a binary glTF 2.0 file: a header, then its JSON and its buffer as chunks (Khronos, "glTF 2.0
// Specification", 4.4).
#include <cstddef>
#include <string>
#include <string_view>

namespace selvedge::sim::glb {

struct Chunks {
    std::string_view json;
    std::string_view binary;  // of a .glb
};

// The first of each kind, as far as they are there; of a .gltf, which has no container, all of it as JSON.
Chunks split(std::string_view content);

// All that comes before the bytes of the buffer in a file with a buffer of that size, which is a multiple of 4 bytes.
std::string head(std::string json, std::size_t buffer_bytes);

std::string container(std::string json, std::string_view buffer);

}  // namespace selvedge::sim::glb
