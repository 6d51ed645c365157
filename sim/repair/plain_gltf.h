#pragma once
// glTF files as tools make them small, written plainly for assimp, which reads no compressed buffers and takes whole
// numbers for floats:
// - EXT_meshopt_compression (Khronos, vendor extension; decoded by meshoptimizer),
// - KHR_mesh_quantization: positions, normals and texture coordinates as whole numbers, normalized or not,
// - the normalized weights of skins and values of animations, which glTF 2.0 itself allows; of weights in bytes, assimp
//   leaves most unset,
// - skins without inverse bind matrices, which are then the identity (glTF 2.0, 5.28.1),
// - buffers in files with escaped names, as "a%20body.bin".
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace selvedge::sim {

// The same file as a .glb with floats in one buffer, without morph targets; nullopt if it is plain already, or no JSON.
// Pre: the content of that .gltf or .glb file, which may be malformed: call it in the guarded child process. Throws
// InputError with the JSON path of what is broken, or if the file requires an extension that is known to change the
// shape and is not read.
std::optional<std::string> plain_gltf(const std::filesystem::path& path, std::string_view content);

}  // namespace selvedge::sim
