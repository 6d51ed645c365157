#pragma once
// Refines the mesh of a draped garment to a curved surface, for pictures and exports: PlainMesh in, PlainMesh out.
// (thesis ch. 6)
#include <optional>

#include "render/surface/adapt_surface.h"
#include "render/surface/edge_curve.h"
#include "sim/mesh/plain_mesh.h"

namespace selvedge::render {

// Normals for lighting. Interpolated normals are smooth and hide detail of the surface.  (thesis fig. 6.6)
enum class LightNormals { Recomputed, Interpolated };

struct CurvedMeshOptions {
    SurfaceKind kind = SurfaceKind::Constant;
    std::optional<int> level{};  // uniform level; none: adaptive, by the criteria
    int deepest_level = 3;       // largest level of the adaptive surface
    SurfaceCriteria criteria{};
    std::optional<sim::ViewPoint> view{};  // if given, what is turned away from it stays coarse; adaptive only
    LightNormals light_normals = LightNormals::Recomputed;
    MoveOptions move{};                 // the body that the surface must not penetrate
    std::vector<CreaseEdge> creases{};  // edges between two triangles of the mesh that stay sharp; their vertices are
                                        // written once per side
};

inline constexpr int kMaxSurfaceLevel = 6;
inline constexpr std::size_t kMaxDrawnTriangles = 20'000'000;

// The result has the coarse mesh's material coordinates, panels and names. Levels count on from those of the coarse
// mesh, to 255 at most; a vertex on an edge between triangles of two levels counts on from the first of them. Without
// material coordinates, a triangle's shape in space is its rest shape. Throws InputError if the mesh cannot be the base
// of a surface (an edge with three triangles, a triangle with two equal corners), or if the result could have more than
// kMaxDrawnTriangles triangles.
sim::PlainMesh curved_mesh(const sim::PlainMesh& coarse, const CurvedMeshOptions& options = {});

}  // namespace selvedge::render
