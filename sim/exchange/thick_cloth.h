#pragma once
// Cloth as a solid: the surface that an infinitely thin mesh has becomes two, half a thickness to either side of it,
// and walls along its borders close them. For 3D printers, which need a closed surface, and for pictures of thick
// cloth.
//
//      x + n t/2   A ------------ B      front: the triangles as they are, at the offset to their right side
//                  |    wall      |
//      x - n t/2   A'------------ B'     back: the same triangles, the other way round
//
// n is the area-weighted mean of the normals of the triangles round a vertex, so that a sewn seam stays closed: its
// vertices belong to the triangles of both panels.
#include <span>

#include "sim/mesh/draw_mesh.h"

namespace selvedge::sim {

// Triangles: the fronts in the order of the mesh, the backs in the same order, then two per border edge. Back and wall
// have the panel of their front and its material coordinates. Each edge of the result has two triangles that have it in
// opposite directions, unless two parts of the mesh meet there that cannot both be oriented, as on a Moebius band.
// Where parts of the mesh meet only in a vertex, each has vertices of its own. Levels are left out. thickness: one per
// panel (DrawMesh::panel), m; a vertex of several panels takes their mean by area. Too large for folds of the cloth,
// the sides cross. Pre: indices are in range.
DrawMesh with_thickness(const DrawMesh& mesh, std::span<const float> thickness);

}  // namespace selvedge::sim
