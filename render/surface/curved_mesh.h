#pragma once
// A garment as it hangs, drawn curved: plain mesh in, plain mesh out, for pictures and exports.  (SPEC 5)
#include <optional>

#include "render/surface/adapt_surface.h"
#include "render/surface/edge_curve.h"
#include "sim/mesh/plain_mesh.h"

namespace selvedge::render {

// Which normals the light sees. Interpolated ones are smooth and hide what the surface has.  (thesis fig. 6.6)
enum class LightNormals { Recomputed, Interpolated };

struct CurvedMeshOptions {
    SurfaceKind kind = SurfaceKind::Constant;
    std::optional<int> level{};  // the same everywhere; none: adaptive, by the criteria
    int deepest_level = 3;       // of the adaptive surface
    SurfaceCriteria criteria{};
    std::optional<sim::ViewPoint> view{};  // with it what is turned away is kept coarse; adaptive only
    LightNormals light_normals = LightNormals::Recomputed;
    MoveOptions move{};                 // the body that it must not dip into
    std::vector<CreaseEdge> creases{};  // edges between two triangles of the mesh that stay sharp; their vertices come
                                        // once for each side
};

inline constexpr int kMostSurfaceLevel = 6;
inline constexpr std::size_t kMostDrawnTriangles = 20'000'000;

// Material coordinates, panels and names are the coarse mesh's; levels count on from its, to 255 at most; a vertex on
// an edge between triangles of two levels counts on from the first of them. A triangle without material
// coordinates is as long as it lies. Throws InputError for a mesh on which no surface can stand (an edge with three
// triangles, a triangle with two equal corners), or that would have more than kMostDrawnTriangles.
sim::PlainMesh curved_mesh(const sim::PlainMesh& coarse, const CurvedMeshOptions& options = {});

}  // namespace selvedge::render
