#pragma once
// Reads untrusted mesh files with assimp in a child process, because assimp crashes or hangs on some malformed files.
// The child has limits on memory, CPU time and wall time, and may read files, but write none. Its result is serialised,
// and lengths, indices and number ranges are checked. Accepted formats, by extension and content: OBJ, glTF 2.0 (.gltf,
// .glb), FBX, and BVH for motion.
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/clip.h"
#include "sim/core/guarded_child.h"
#include "sim/core/math.h"

namespace selvedge::sim {

// Of a skeleton and its clips.
struct MotionLimits {
    std::size_t joints = 4096;  // a rig with fingers and a face has 900, and FBX adds up to three pivots to each
    std::size_t clips = 1000;
    ClipLimits clip{};
};

// What is wanted of a file: triangles, which it must have, and what moves them; or skeleton and clips alone.
enum class ImportKind { Surface, Motion };

struct ImportLimits {
    std::size_t file_bytes = std::size_t(256) << 20;
    ChildLimits child{};
    std::size_t vertices = 8'000'000;  // OBJ readers create three for each triangle
    std::size_t triangles = 4'000'000;
    MotionLimits motion{};
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

// If anything of the scene is skinned or animated, its nodes are the bones: so no transform on the way is lost. Lengths
// are in the file's unit and axes, also those of `joint` and `inverse_bind`.
struct ImportedScene {
    std::vector<ImportedMesh> meshes;  // none if only motion was asked for
    std::vector<Bone> bones;           // each parent precedes its children
    std::vector<Clip> clips;
    bool is_y_up = false;  // the file says so
};

// Throws InputError when the format is not accepted, the file exceeds a limit, or the reader fails or crashes. Post:
// indices are in range; numbers are finite and at most 1e6 in magnitude; check_clip() holds.
ImportedScene guarded_import(const std::filesystem::path& path, ImportKind kind = ImportKind::Surface,
                             const ImportLimits& limits = {});

// The same in this process, which a malformed file may crash or stop for ever: for fuzzers and debuggers.
ImportedScene unguarded_import(const std::filesystem::path& path, ImportKind kind = ImportKind::Surface,
                               const ImportLimits& limits = {});

// What the child process sends to its parent: an ImportedScene, or the reason for its failure.

struct ImportAnswer {
    std::string failure;  // empty on success
    ImportedScene scene;
};

std::string to_bytes(const ImportAnswer& answer);

// nullopt when the bytes are not a valid ImportAnswer.
std::optional<ImportAnswer> from_bytes(std::string_view bytes);

// The scene in an answer, which a malformed file may have corrupted. Throws as guarded_import(), with the same
// postcondition.
ImportedScene scene_of(ImportAnswer answer, const std::filesystem::path& path, ImportKind kind,
                       const ImportLimits& limits = {});

// Converts assimp's scene to ours. It does not check the file: call it in the guarded child process only.

// extension: "obj", "gltf", "glb", "fbx" or "bvh"; all importers for other extensions are disabled. Skinned vertices
// are placed in the rest pose of their bones. What has no weights in a scene with bones follows its node.
ImportAnswer read_with_assimp(const std::string& path, const std::string& extension,
                              ImportKind kind = ImportKind::Surface, const MotionLimits& limits = {});

}  // namespace selvedge::sim
