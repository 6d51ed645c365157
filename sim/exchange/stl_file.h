#pragma once
// Writes binary STL, the format of 3D printers (80 bytes of text, the number of triangles, 50 bytes for each).
// STL states no unit; programs that read it take millimetres.
#include <string>

#include "sim/body/body.h"
#include "sim/exchange/garment_export.h"
#include "sim/mesh/draw_mesh.h"

namespace selvedge::sim {

// The bytes of the file: millimetres, y up. STL has no vertices in common, no panels and no texture coordinates.
// With a body, its triangles come last; the text at the beginning says how many those of the cloth are.
// Pre: indices are in range, and there is at least one triangle.
std::string garment_stl(const DrawMesh& mesh, const GarmentExport& content = {});
std::string body_stl(const Body& body);

}  // namespace selvedge::sim
