#pragma once
// Sewing must not fold a mesh onto itself: an inner edge from one seam to another may find both its ends merged with
// the ends of a second edge, or with each other, and then triangles collapse or three of them share an edge. (SPEC 3.1)
#include "sim/mesh/garment_mesh.h"

namespace selvedge {

// Splits such inner edges in the middle until sewing brings no two of them together; edges on outlines are never
// touched. Returns how many were split.
//
//     A ______ A'     A and A' are sewn together: the chord AA' would vanish
//      \  |  /
//       \ | /  ->  each split edge gets a vertex of its own, and its triangles two or more
//        \|/
int separate_coinciding_edges(GarmentMesh& unsewn);

}  // namespace selvedge
