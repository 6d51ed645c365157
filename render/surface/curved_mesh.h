#pragma once
// The mesh that renderers and exporters take from a curved surface; and a mesh, such as one from a file, refined to a
// curved surface: PlainMesh in, PlainMesh out.  (thesis ch. 6)
#include <vector>

#include "render/surface/curve.h"
#include "sim/mesh/plain_mesh.h"

namespace selvedge::render {

// Normals for lighting. Interpolated normals are smooth and hide detail of the surface.  (thesis fig. 6.6)
enum class LightNormals { Recomputed, Interpolated };

// The leaves of the surface, in the order of their base triangles; a vertex on a crease once per side. base: the mesh
// that the surface was made over, in the same order, of which the result has the panels and names, and material
// coordinates if it has them. Levels count on from those of the base, to 255 at most; a vertex on an edge between
// triangles of two levels counts on from the first of them.
sim::PlainMesh plain_mesh(const CurvedSurface& surface, const sim::PlainMesh& base,
                          LightNormals normals = LightNormals::Recomputed);

struct CurvedMeshOptions {
    CurveOptions curve{};
    LightNormals light_normals = LightNormals::Recomputed;
    std::vector<CreaseEdge> creases{};  // edges between two triangles of the mesh that stay sharp
};

// Without material coordinates, a triangle's shape in space is its rest shape. Throws InputError as curve() does.
sim::PlainMesh curved_mesh(const sim::PlainMesh& coarse, const CurvedMeshOptions& options = {});

}  // namespace selvedge::render
