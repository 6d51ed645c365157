#pragma once
// From a pattern to its unsewn mesh: every panel triangulated, placed in the room, and linked to its neighbours along
// the seams.  (SPEC 3.1)
#include <vector>

#include "sim/mesh/garment_mesh.h"
#include "sim/mesh/merge_seams.h"
#include "sim/mesh/mesh_options.h"
#include "sim/mesh/panel_mesh.h"
#include "sim/pattern/pattern.h"

namespace selvedge {

// The unsewn garment. Along a seam, sample i of one side is linked to sample i (or n - i) of the other, ends included.
// Post: merge_seams() of the result has no triangle with two equal vertices and no edge with three triangles, unless
// the pattern itself sews three edges together.
// Throws InputError for a self-crossing outline (naming the panel), for a seam to a missing edge or of an edge with
// itself, and for a panel that would need more than options.max_triangles.
GarmentMesh assemble(const Pattern& pattern, const MeshOptions& options = {});

// What panels were cut into the last time, and from what.
struct KeptPanelMesh {
    std::vector<Vec2d> vertices;
    std::vector<OutlineEdge> edges;
    std::vector<int> segments;
    MeshOptions options;
    PanelMesh mesh;
};

// The same garment, but panels whose outline and segments are in `kept` are not cut anew. Post: `kept` is of this one.
GarmentMesh assemble(const Pattern& pattern, const MeshOptions& options, std::vector<KeptPanelMesh>& kept);

}  // namespace selvedge
