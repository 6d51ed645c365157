#pragma once
// Reads other people's mesh files with assimp in a child process, for it crashes or hangs on some mutated files. The
// child has limits of memory, processor time and wall clock; what it hands back is flat, length-checked and finite.
// Only formats on a list are read: OBJ and glTF 2.0 (.gltf, .glb), known by extension and by content.
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
    std::size_t memory_bytes = std::size_t(2) << 30;  // beyond what the program has; not under sanitizers
    int processor_seconds = 20;
    int wall_seconds = 30;
    std::size_t vertices = 8'000'000;  // OBJ readers make three for each triangle
    std::size_t triangles = 4'000'000;
};

// One mesh as it stands in the scene, transforms applied, in the file's unit and axes. Polygons are triangulated.
struct ImportedMesh {
    std::string name;
    std::string material;
    std::vector<Vec3f> x;
    std::vector<Vec2f> u;  // per vertex, v upward; empty when the mesh has none
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<SkinWeights> skin;  // of the scene's bones; empty when the mesh has none
};

struct ImportedScene {
    std::vector<ImportedMesh> meshes;
    std::vector<Bone> bones;  // parents come first
};

// Throws InputError when the format is not on the list, the file breaks a limit, or the reader fails or crashes.
// Post: indices are in range, numbers finite and no larger than 1e6.
ImportedScene guarded_import(const std::filesystem::path& path, const ImportLimits& limits = {});

// What the importing child sends to its parent: an ImportedScene, or why there is none.

struct ImportAnswer {
    std::string failure;  // empty when there is a scene
    ImportedScene scene;
};

std::string to_bytes(const ImportAnswer& answer);

// Nothing when the bytes are no such answer.
std::optional<ImportAnswer> from_bytes(std::string_view bytes);

// assimp's scene as ours. It trusts the file: only the guarded child calls it.

// extension: "obj" or "gltf"; no other importer than that one is asked. Rest pose: skinned vertices stand where their
// bones put them.
ImportAnswer read_with_assimp(const std::string& path, const std::string& extension);

}  // namespace selvedge::sim
