#pragma once
// Writes binary little-endian PLY (Turk 1994, "The PLY Polygon File Format"), the format of scanners and of programs
// for measured meshes.
#include <string>

#include "sim/body/body.h"
#include "sim/exchange/garment_export.h"
#include "sim/mesh/draw_mesh.h"

namespace selvedge::sim {

// The bytes of the file: metres, y up. Properties of a vertex: x y z, nx ny nz, s t (the panels packed in the unit
// square), material_u material_v (m; these four only if the mesh has material coordinates), panel (its index; a comment
// "panel INDEX NAME" names each) and seam (1 where the vertex lies on a seam, 0 elsewhere). A vertex on a seam is there
// once for each of its material coordinates. With a body, its vertices come last: panel -1, seam 0, and texture and
// material coordinates of zero; so do its faces.
// Pre: indices are in range, and there is at least one triangle. Throws InputError if the panels do not fit.
std::string garment_ply(const DrawMesh& mesh, const GarmentExport& content = {});

// The same without s t, panel and seam.
std::string body_ply(const Body& body);

}  // namespace selvedge::sim
