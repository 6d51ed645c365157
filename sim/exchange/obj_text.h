#pragma once
// Writes Wavefront OBJ text: garments with one group per panel, and bodies. Reads back the panel data that only
// Selvedge writes.
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/body/body.h"
#include "sim/exchange/garment_export.h"
#include "sim/mesh/draw_mesh.h"

namespace selvedge::sim {

// The text of the file. Pre: indices are in range.
std::string garment_obj(const DrawMesh& mesh, const GarmentExport& content = {});

// The materials (Wavefront MTL) that garment_obj() names, and their pictures; none without textures. Materials come
// last, so that what they name is there. Normals: "norm", as Blender reads it.
std::vector<FileBeside> files_beside_obj(const GarmentExport& content);

std::string body_obj(const Body& body);

// Group names with the grain angles (rad) that garment_obj() writes in comments after the group lines; empty for files
// of other programs.
std::vector<std::pair<std::string, float>> grain_angles_in_obj(std::string_view text);

// The same for sett offsets (m, (weft, warp)); garment_obj() writes those that are not zero.
std::vector<std::pair<std::string, Vec2f>> sett_offsets_in_obj(std::string_view text);

// The same for charts: how the panels were packed in vt.
std::vector<std::pair<std::string, UvChart>> charts_in_obj(std::string_view text);

}  // namespace selvedge::sim
