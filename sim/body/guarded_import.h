#pragma once
// Reads untrusted mesh files with assimp in a child process, because assimp crashes or hangs on some malformed files.
// The child has limits on memory, CPU time and wall time. Its result is serialised, and lengths, indices and number
// ranges are checked. Accepted formats, by extension and content: OBJ and glTF 2.0 (.gltf, .glb).
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/body/body.h"
#include "sim/core/math.h"

namespace selvedge::sim {

struct ImportLimits {
    std::size_t file_bytes = std::size_t(256) << 20;
    std::size_t memory_bytes = std::size_t(2) << 30;  // on top of what is in use; not applied under AddressSanitizer
    int processor_seconds = 20;
    int wall_seconds = 30;
    std::size_t vertices = 8'000'000;  // OBJ readers create three for each triangle
    std::size_t triangles = 4'000'000;
};

// One mesh instance of the scene with transforms applied, in the file's unit and axes. Polygons are triangulated.
struct ImportedMesh {
    std::string name;
    std::string material;
    std::vector<Vec3f> x;
    std::vector<Vec2f> u;  // per vertex, v upward; empty when the mesh has none
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<SkinWeights> skin;  // indices into the scene's bones; empty when the mesh has none
};

struct ImportedScene {
    std::vector<ImportedMesh> meshes;
    std::vector<Bone> bones;  // each parent precedes its children
};

// Throws InputError when the format is not accepted, the file exceeds a limit, or the reader fails or crashes. Post:
// indices are in range; numbers are finite and at most 1e6 in magnitude.
ImportedScene guarded_import(const std::filesystem::path& path, const ImportLimits& limits = {});

// What the child process sends to its parent: an ImportedScene, or the reason for its failure.

struct ImportAnswer {
    std::string failure;  // empty on success
    ImportedScene scene;
};

std::string to_bytes(const ImportAnswer& answer);

// nullopt when the bytes are not a valid ImportAnswer.
std::optional<ImportAnswer> from_bytes(std::string_view bytes);

// Converts assimp's scene to ours. It does not check the file: call it in the guarded child process only.

// extension: "obj", "gltf" or "glb"; all importers for other extensions are disabled. Skinned vertices are placed in
// the rest pose of their bones.
ImportAnswer read_with_assimp(const std::string& path, const std::string& extension);

}  // namespace selvedge::sim
