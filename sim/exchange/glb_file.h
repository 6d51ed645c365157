#pragma once
// Binary glTF 2.0 (Khronos, "glTF 2.0 Specification", chapter 4.4 for the container): garments with a primitive per
// panel, bodies with their skeleton and skin.
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/body/body.h"
#include "sim/mesh/plain_mesh.h"

namespace selvedge::sim {

std::string garment_glb(const PlainMesh& mesh);
std::string body_glb(const Body& body);

// Panel names with the grain angles (rad) that garment_glb wrote as extras; none in others' files.
// Pre: a loader has accepted the bytes; `file` names them in errors.
std::vector<std::pair<std::string, float>> grain_angles_in_glb(std::string_view bytes, const std::string& file);

// The same for sett offsets (m, weft and warp), which garment_glb writes where a panel has one.
std::vector<std::pair<std::string, Vec2f>> sett_offsets_in_glb(std::string_view bytes, const std::string& file);

}  // namespace selvedge::sim
