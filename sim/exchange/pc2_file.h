#pragma once
// Writes point caches in the format PC2, which Blender (modifier Mesh Cache), 3ds Max, Houdini and Cinema 4D read:
//
//   "POINTCACHE2\0"   12 characters
//   version           int32, 1
//   points            int32
//   start frame       float32
//   sampling rate     float32: frames from one sample to the next
//   samples           int32
//   positions         float32, x y z of each point of the first sample, then of the next; little-endian throughout
//
// The number of samples is brought up to date with every sample, so that even the temporary file of a program that was
// killed can be read, until another one writes into its folder. Topology is not in the file: cache.obj beside it has
// the same order of vertices.
#include <filesystem>
#include <memory>

#include "sim/exchange/mesh_cache.h"

namespace selvedge::sim {

// As open_mesh_cache().
std::unique_ptr<MeshCache> open_pc2_cache(const std::filesystem::path& path, const DrawMesh& mesh,
                                          const CacheOptions& options);

// The file beside such a cache that holds the first frame's mesh: cache.obj.
std::filesystem::path mesh_beside(const std::filesystem::path& cache);

}  // namespace selvedge::sim
