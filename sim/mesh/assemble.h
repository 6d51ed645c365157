#pragma once
// From a pattern to its unsewn mesh: every panel triangulated, placed in the room, and linked to its neighbours along
// the seams; and from that to the sewn mesh, in which linked vertices are one.  (SPEC 3.1)
#include <vector>

#include "sim/mesh/garment_mesh.h"
#include "sim/mesh/mesh_options.h"
#include "sim/pattern/pattern.h"

namespace selvedge {

// The unsewn garment. Along a seam, sample i of one side is linked to sample i (or n - i) of the other, ends included.
// Post: merge_seams() of the result has no triangle with two equal vertices and no edge with three triangles, unless
// the pattern itself sews three edges together.
// Throws InputError for a self-crossing outline (naming the panel), for a seam to a missing edge or of an edge with
// itself, and for a panel that would need more than options.max_triangles.
GarmentMesh assemble(const Pattern& pattern, const MeshOptions& options = {});

struct SewnMesh {
    GarmentMesh mesh;
    std::vector<int> sewn_vertex;  // per vertex of the unsewn mesh: its vertex in `mesh`
};

// Joins linked vertices, also where several seams meet in one point, at the mean of their positions. Triangles keep
// their order and their corners' material coordinates; vertices keep their order by first appearance.
SewnMesh merge_seams(const GarmentMesh& unsewn);

}  // namespace selvedge
