#pragma once
// Animation caches: a mesh whose topology stays, with its positions at every frame, for programs that do not simulate.
// The extension selects the format:
//   cache.pc2     positions of all frames (sim/exchange/pc2_file.h); cache.obj beside it holds the first frame's mesh
//                 with the same order of vertices, material coordinates and panels;
//   cache.glb     one morph target per frame and an animation of their weights (sim/exchange/glb_cache.h); a body too,
//                 by its bones;
//   frames/*.obj  one file per frame, as write_garment() writes it; the frame's number takes the place of the asterisk,
//                 with at least four digits. The folder is made if it does not exist;
//   frames/       as frames/*.obj.
// A .pc2 or .glb file is a temporary file until finish(); if the cache is destroyed before, the old file remains.
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/pose.h"
#include "sim/core/math.h"
#include "sim/exchange/garment_export.h"
#include "sim/mesh/draw_mesh.h"

namespace selvedge::sim {

// How a viewer shows the time between two frames.
enum class CacheInterpolation { Linear, Step };

struct CacheOptions {
    std::size_t frames = 1;         // that are planned, at least 1; finish() may come earlier
    double frames_per_second = 30;  // above 0
    int first_frame = 1;            // its number in file names, in names of morph targets and in .pc2
    // Of .glb only:
    CacheInterpolation interpolation = CacheInterpolation::Linear;
    bool has_normals = true;      // also the normals of every frame: twice the size; Blender computes its own
    const Body* bones = nullptr;  // of the body, with its skin: it goes with them, and only what its flesh gives way is
                                  // left to morph targets; it lives until finish(). None: the body is morph targets
    bool binds_garment = false;   // with bones: the garment goes with them too, and morph targets hold the rest
    AtlasOptions atlas{};         // where the garment's panels are in the first set of texture coordinates
    GarmentTextures textures{};
};

class MeshCache {
 public:
    virtual ~MeshCache() = default;
    MeshCache() = default;
    MeshCache(const MeshCache&) = delete;
    MeshCache& operator=(const MeshCache&) = delete;

    // Positions of the next frame, m, in the order of the mesh; `body` only if the cache has a body. Throws InputError
    // if a number is not finite or the disk is full. pose: of CacheOptions::bones, with these.
    // Pre: fewer frames than planned have been added.
    virtual void add(const std::vector<Vec3f>& garment, const std::vector<Vec3f>& body = {},
                     const Pose* pose = nullptr) = 0;

    // Makes the file appear, with as many frames as were added. Pre: at least one frame; called once.
    virtual void finish() = 0;
};

// Throws InputError, before it writes anything, if the extension is of no format, the mesh has no triangles, the
// planned frames exceed what the format can hold or what is free on the disk, or the file cannot be written.
// garment: a mesh such as FixedMesh::mesh, of which the positions and normals are not used.
// body: only for .glb; positions are not used. Give a .pc2 or .obj cache of a body its mesh as `garment` instead.
std::unique_ptr<MeshCache> open_mesh_cache(const std::filesystem::path& path, const DrawMesh& garment,
                                           const CacheOptions& options, const DrawMesh* body = nullptr);

// Whether the path names a cache: ends in .pc2, .glb or *.obj, or is a folder, which ends in a slash or is there.
bool is_mesh_cache(const std::filesystem::path& path);

// The file of one frame of "frames/*.obj" or "frames/": frames/0001.obj.
std::filesystem::path frame_path(const std::filesystem::path& pattern, int frame);

// A body's surface as a mesh of one panel called "body", without material coordinates.
DrawMesh body_mesh(const Body& body);

// Throws InputError(path, "frame 12, vertex 3", ...) at the first number that is not finite.
void require_finite(const std::filesystem::path& path, int frame, const std::vector<Vec3f>& x);

}  // namespace selvedge::sim
