#pragma once
// Checks of a glTF file that assimp does not make: it drops weights for joints that a skin does not have, and the
// vertices stay behind when the body moves.
#include <filesystem>
#include <string_view>

namespace selvedge::sim {

// Pre: the content of that .gltf or .glb file. Throws InputError with the JSON path of the accessor if a vertex has a
// weight for a joint that is not in its skin. What else is broken or not understood is left to the reader.
void check_gltf_skins(const std::filesystem::path& path, std::string_view content);

}  // namespace selvedge::sim
