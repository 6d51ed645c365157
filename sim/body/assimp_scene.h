#pragma once
// assimp's scene as ours. It trusts the file: only the guarded child calls it.
#include <string>

#include "sim/body/scene_bytes.h"

namespace selvedge {

// extension: "obj" or "gltf"; no other importer than that one is asked. Rest pose: skinned vertices stand where their
// bones put them.
ImportAnswer read_with_assimp(const std::string& path, const std::string& extension);

}  // namespace selvedge
