#pragma once
// Writes an animated garment, and the body that wears it, as binary glTF 2.0 without extensions: a mesh each, whose
// first frame is the mesh itself and whose other frames are morph targets ("glTF 2.0 Specification", 3.7.2.2), and one
// animation of their weights: at each frame the weight of its target is 1 and the others are 0. Morph targets are
// sparse where few vertices move (3.6.2.3). Panels, materials, textures and material coordinates are those of
// garment_glb(). With bones (CacheOptions::bones) the body, and the garment by choice, is a skin (3.7.3): morph
// targets, which act before the skin, hold what the bones do not do.
//
// Frames are written as they come. The JSON precedes them in the file, so room for it is reserved first, from a plan of
// all accessors with bounds of the greatest length; what remains of it is blank. A file has at most 4 GiB.
#include <filesystem>
#include <memory>

#include "sim/exchange/mesh_cache.h"

namespace selvedge::sim {

// As open_mesh_cache().
std::unique_ptr<MeshCache> open_glb_cache(const std::filesystem::path& path, const DrawMesh& garment,
                                          const CacheOptions& options, const DrawMesh* body = nullptr);

}  // namespace selvedge::sim
