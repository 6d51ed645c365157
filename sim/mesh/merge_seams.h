#pragma once
// From the unsewn mesh to the sewn one, in which linked vertices are one.  (SPEC 3.1, 3.2)
#include <vector>

#include "sim/mesh/garment_mesh.h"

namespace selvedge {

struct SewnMesh {
    GarmentMesh mesh;
    std::vector<int> sewn_vertex;  // per vertex of the unsewn mesh: its vertex in `mesh`
};

// Joins linked vertices, also where several seams meet in one point, at the mean of their positions. Triangles keep
// their order and their corners' material coordinates; vertices keep their order by first appearance.
SewnMesh merge_seams(const GarmentMesh& unsewn);

}  // namespace selvedge
