#pragma once
// The example of docs/adding-a-format.md: binary STL, the format of 3D printers.
#include <string>

#include "sim/body/body.h"
#include "sim/exchange/mesh_file.h"
#include "sim/mesh/draw_mesh.h"

namespace selvedge::sim {

// [header]
// The bytes of the file: metres, y up. STL has no vertices in common, no panels and no material coordinates.
// Pre: indices are in range, and there is at least one triangle.
std::string garment_stl(const DrawMesh& mesh);
std::string body_stl(const Body& body);
// [/header]

extern const MeshFormat kStl;

}  // namespace selvedge::sim
