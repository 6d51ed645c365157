#pragma once
// The example of docs/adding-a-format.md: OFF, a text format of vertices and polygons.
#include <string>

#include "sim/body/body.h"
#include "sim/exchange/mesh_file.h"
#include "sim/mesh/draw_mesh.h"

namespace selvedge::sim {

// [header]
// The text of the file: metres, y up. OFF has no panels, no normals and no material coordinates.
// Pre: indices are in range, and there is at least one triangle.
std::string garment_off(const DrawMesh& mesh, const GarmentExport& content = {});
std::string body_off(const Body& body);
// [/header]

extern const MeshFormat kOff;

}  // namespace selvedge::sim
