#pragma once
// The curved surface over a cloth, kept from frame to frame; and the curved surface over any triangles.  (thesis ch. 6)
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "render/surface/adapt_surface.h"
#include "render/surface/curved_surface.h"
#include "render/surface/edge_curve.h"
#include "sim/adaptive/adaptive_mesh.h"
#include "sim/core/math.h"
#include "sim/core/view_point.h"
#include "sim/mesh/draw_mesh.h"
#include "sim/mesh/garment_mesh.h"

namespace selvedge::sim {
struct Cloth;
}

namespace selvedge::render {

inline constexpr int kMaxSurfaceLevel = 6;
inline constexpr std::size_t kMaxDrawnTriangles = 20'000'000;

struct CurveOptions {
    CurveModifier modifier{};    // how far curves leave their chords; curve_modifier() has presets
    std::optional<int> level{};  // uniform level, 0..kMaxSurfaceLevel; none: adaptive, by the criteria
    int deepest_level = 3;       // largest level of the adaptive surface, 0..kMaxSurfaceLevel
    SurfaceCriteria criteria{};
    std::optional<sim::ViewPoint> view{};  // if given, what is turned away from it stays coarse; adaptive only
    MoveOptions move{};                    // the body that the surface must not penetrate
    // For a surface that is kept from frame to frame, adaptive only. false: each frame is refined until no edge
    // changes. true: each frame adapts the surface once, and its vertices move in and out gradually
    // (AdaptSurfaceOptions).
    bool glides = false;
};

// A surface over triangles, refined. x: positions of their vertices, m, w = 0. creases: see SurfaceOptions.
// Throws InputError if they cannot be the base of a surface (an edge with three triangles, a triangle with two equal
// corners), or if the surface could have more than kMaxDrawnTriangles triangles.
CurvedSurface curve(std::span<const Vec4f> x, std::span<const sim::GarmentTriangle> triangles,
                    const CurveOptions& options = {}, const std::vector<CreaseEdge>& creases = {});

// The surface over the leaf triangles of a cloth. Its base has their order, and its base vertices that of the leaf
// vertices, as draw_mesh(cloth) does (sim/cloth/cloth.h).
class SurfaceOverCloth {
 public:
    // The surface over the cloth as it is now. While the leaves are those of the last call, the surface only moves and
    // adapts; if they are others, also because the cloth is another one, it is made anew and refined at once.
    // Valid until the next call. Throws InputError if the surface could have more than kMaxDrawnTriangles triangles.
    const CurvedSurface& curve(const sim::Cloth& cloth, const CurveOptions& options = {});

 private:
    bool is_over(const sim::AdaptiveMesh& mesh) const;

    std::optional<CurvedSurface> surface_;
    // What the surface was made for. Cloth::adaptations does not tell whether the leaves are others: it also counts
    // adaptations that changed nothing, and two cloths may have the same number.
    std::vector<sim::VertexId> vertices_;
    std::vector<sim::LeafTriangle> triangles_;
    CurveModifier modifier_{};
    std::vector<Vec4f> normals_;  // by the cloth's VertexId, scratch
};

// The mesh that renderers and exporters take from a curved surface; and a mesh, such as one from a file, refined to a
// curved surface: DrawMesh in, DrawMesh out.  (thesis ch. 6)

// Normals for lighting. Interpolated normals are smooth and hide detail of the surface.  (thesis fig. 6.6)
enum class LightNormals { Recomputed, Interpolated };

// The leaves of the surface, in the order of their base triangles; a vertex on a crease once per side. base: the mesh
// that the surface was made over, in the same order, of which the result has the panels and names, and material
// coordinates if it has them. Levels count on from those of the base, to 255 at most; a vertex on an edge between
// triangles of two levels counts on from the first of them.
sim::DrawMesh draw_mesh(const CurvedSurface& surface, const sim::DrawMesh& base,
                        LightNormals normals = LightNormals::Recomputed);

struct CurvedMeshOptions {
    CurveOptions curve{};
    LightNormals light_normals = LightNormals::Recomputed;
    std::vector<CreaseEdge> creases{};  // edges between two triangles of the mesh that stay sharp
};

// Without material coordinates, a triangle's shape in space is its rest shape. Throws InputError as curve() does.
sim::DrawMesh curved_mesh(const sim::DrawMesh& coarse, const CurvedMeshOptions& options = {});

}  // namespace selvedge::render
