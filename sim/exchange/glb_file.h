#pragma once
// Writes binary glTF 2.0 (Khronos, "glTF 2.0 Specification"; the container is in chapter 4.4): garments with one
// primitive per panel, bodies with skeleton and skin. Reads back the panel data that only Selvedge writes.
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/body/body.h"
#include "sim/exchange/garment_export.h"
#include "sim/exchange/uv_atlas.h"
#include "sim/mesh/draw_mesh.h"

namespace selvedge::sim {

// The bytes of the file. Pre: indices are in range, and there is at least one triangle. Throws InputError if the panels
// do not fit in the texture.
std::string garment_glb(const DrawMesh& mesh, const GarmentExport& content = {});
std::string body_glb(const Body& body);

// Panel names with the grain angles (rad) that garment_glb() writes as extras; empty for files of other programs.
// Pre: a glTF loader has accepted the bytes. `file` is the name in error messages.
std::vector<std::pair<std::string, float>> grain_angles_in_glb(std::string_view bytes, const std::string& file);

// The same for sett offsets (m, (weft, warp)); garment_glb() writes those that are not zero.
std::vector<std::pair<std::string, Vec2f>> sett_offsets_in_glb(std::string_view bytes, const std::string& file);

// The same for charts: how the panels were packed in TEXCOORD_0.
std::vector<std::pair<std::string, UvChart>> charts_in_glb(std::string_view bytes, const std::string& file);

}  // namespace selvedge::sim
