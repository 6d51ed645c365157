#pragma once
// Wavefront OBJ as text: garments with a group per panel, bodies.
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/body/body.h"
#include "sim/mesh/plain_mesh.h"

namespace selvedge::sim {

std::string garment_obj(const PlainMesh& mesh);
std::string body_obj(const Body& body);

// Group names with the grain angles (rad) that garment_obj wrote in comments behind them; none in others' files.
std::vector<std::pair<std::string, float>> grain_angles_in_obj(std::string_view text);

// The same for sett offsets (m, weft and warp), which garment_obj writes where a panel has one.
std::vector<std::pair<std::string, Vec2f>> sett_offsets_in_obj(std::string_view text);

}  // namespace selvedge::sim
