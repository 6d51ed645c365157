#pragma once
// The drawn surface: an adaptive mesh of its own, with the coarse cloth's triangles as base. Each new vertex lies on
// the curve of a root edge.  (thesis ch. 6)
//
// A root edge is an edge of the base, or an edge inside a refined triangle. Vertices on it lie on its curve at t =
// i/2^k, in whatever order it was split; the ends of a root edge always exist before it is split. So curves are
// computed level by level, each vertex is evaluated once, and no vertex moves because another one is added or removed.
//
// Order: base edges, their vertices, edges inside triangles of level 0, their vertices, edges of level 1, and so on.
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "render/surface/edge_curve.h"
#include "sim/adaptive/adapt.h"
#include "sim/adaptive/adaptive_mesh.h"
#include "sim/core/math.h"
#include "sim/mesh/garment_mesh.h"

namespace selvedge::sim {
class Collider;
}

namespace selvedge::render {

// Creases: base edges at which the drawn surface stays sharp, such as a pressed fold. Along a crease the surface has
// one normal per side, and the crease's curve lies in the tangent planes of both sides.  (Vlachos et al. 2001, 4.2)
// Cuts (AdaptiveMesh::is_cut) are creases too, because the normals of their sides have no common orientation.

// The two base vertices of an edge.
using CreaseEdge = std::array<int, 2>;

// A vertex on a crease, seen from one side. At a base vertex, a side is a group of smoothly joined triangles around it,
// and its number is that of one of their corners there. At a new vertex, it is 0 or 1, a side of the root edge.
using SidedVertex = std::pair<sim::VertexId, std::uint32_t>;

struct Creases {
    std::vector<bool> is_crease{};                            // by base EdgeId; empty: no creases
    std::vector<std::array<std::uint32_t, 3>> corner_side{};  // by base triangle: side numbers at its corners
    std::vector<bool> is_creased{};                           // by base vertex: whether it lies on a crease
    std::vector<sim::TriangleId> base_of{};                   // by TriangleId: the base triangle that contains it
    std::map<SidedVertex, Vec4f> normals{};                   // of the curves, unit
    std::map<SidedVertex, Vec4f> light_normals{};             // of the drawn triangles, unit

    bool empty() const { return is_crease.empty(); }
};

// The cuts are added to the edges. Pre: mesh is at level 0; each edge is a base edge with a triangle on both sides.
Creases find_creases(const sim::AdaptiveMesh& mesh, std::span<const CreaseEdge> edges);

// Updates base_of for the children of t. Call after t has changed its configuration.
void note_children(Creases& creases, const sim::AdaptiveMesh& mesh, sim::TriangleId t);

// Sets `normals`: area-weighted sums over the base triangles, normalized. x: by VertexId, m.
void update_base_normals(Creases& creases, const sim::AdaptiveMesh& mesh, const std::vector<Vec4f>& x);
// Sets `light_normals`: the same over the leaf triangles. roots: by VertexId, the root edges for sided().
void update_light_normals(Creases& creases, const sim::AdaptiveMesh& mesh, const std::vector<sim::EdgeId>& roots,
                          const std::vector<Vec4f>& x);

// v as seen from the base triangle `base`; nullopt if v lies on no crease. root: the edge whose curve v lies on;
// ignored if v is a base vertex.
std::optional<SidedVertex> sided(const Creases& creases, const sim::AdaptiveMesh& mesh, sim::VertexId v,
                                 sim::EdgeId root, sim::TriangleId base);

// The curve of a crease, from the ends as seen from its two sides. Its normals are those of `first`.
EdgeCurve make_crease_curve(const CurveEnds& first, const CurveEnds& second, const CurveModifier& modifier);

struct SurfaceOptions {
    CurveModifier modifier{};
    int max_level = 3;
    std::vector<CreaseEdge> creases{};  // edges that stay sharp
};

// The part of its root's curve that an edge covers, in steps of 1/2^max_level: from `from` to `from + span`.
struct CurveInterval {
    sim::EdgeId root;
    std::uint16_t from = 0;
    std::uint16_t span = 0;
};

// The curves and vertices that update_surface() computes, sorted by level. plan_surface() rebuilds it.
struct SurfacePlan {
    struct Curve {
        sim::VertexId a, b;
        float rest_length = 0;  // m
        sim::EdgeId root;
    };
    struct Point {
        sim::VertexId v;
        sim::VertexId a, b;       // ends of the edge with centre v
        std::uint32_t curve = 0;  // index in curves
        std::uint32_t step = 0;   // t in steps of 1/2^max_level
    };
    std::vector<Curve> curves;
    std::vector<Point> points;
    std::vector<std::size_t> curve_ends, point_ends;  // by level: one past its last element
    std::vector<std::uint32_t> curve_of;              // by EdgeId, for roots; scratch
};

struct CurvedSurface {
    sim::AdaptiveMesh mesh;
    CurveModifier modifier{};
    CurveWeights weights{0};

    // By VertexId, sized to the mesh's capacity; the fourth component (w) is 0.
    std::vector<Vec4f> x{};               // as drawn, m
    std::vector<Vec4f> normals{};         // unit, of the curves, interpolated from their end normals
    std::vector<Vec4f> light_normals{};   // unit, of the drawn triangles
    std::vector<float> shown{};           // 0: at the midpoint of its edge, 1: on the curve
    std::vector<bool> is_leaving{};       // moving back to the midpoint, where it may be removed
    std::vector<CurveInterval> places{};  // by EdgeId

    Creases creases{};
    SurfacePlan plan{};
    std::vector<EdgeCurve> curves{};  // of plan.curves
    std::vector<float> clear{};       // m, lower bound of the distance from the body, scratch
};

// Makes the surface at level 0, equal to the base. x: positions of the base vertices, m, w = 0. The triangles' material
// coordinates give the rest lengths. Throws InputError as AdaptiveMesh does.
CurvedSurface make_curved_surface(std::span<const Vec4f> x, std::span<const sim::GarmentTriangle> triangles,
                                  const SurfaceOptions& options = {});
// The same over a sewn garment. Pre: base has no links.
CurvedSurface make_curved_surface(const sim::GarmentMesh& base, const SurfaceOptions& options = {});

struct MoveOptions {
    const sim::Collider* body =
        nullptr;               // the surface must not penetrate it: vertices are moved out to its offset surface
    float offset = 0.0003F;    // m, offset of that surface; the same as the cloth's contact offset
    float max_step = 0.0002F;  // m, largest move of a vertex towards or from its edge's midpoint in one call
};

// Moves the surface to the cloth's present position; call once per frame. x, normals: of the base vertices, with w = 0;
// normals are unit. A new vertex moves gradually from its edge's midpoint to its curve, once both ends of the edge have
// reached their curves; a vertex that is to be removed moves back (see adapt_surface.h). So no vertex jumps when the
// level changes.
void update_surface(CurvedSurface& surface, std::span<const Vec4f> x, std::span<const Vec4f> normals,
                    const MoveOptions& options = {});

// The two parts of update_surface(): positions with the curves' normals; then the normals for lighting. Interpolated
// normals hide detail of the surface, so lighting normals are recomputed from its triangles, weighted by area.
// (thesis fig. 6.6)
void move_surface(CurvedSurface& surface, std::span<const Vec4f> x, std::span<const Vec4f> normals,
                  const MoveOptions& options = {});
void update_light_normals(CurvedSurface& surface);

// Area-weighted normals of a mesh's leaves, by VertexId: the end normals that a coarse cloth gives to the curves.
// (Other weights, and normals extrapolated at hems, came no closer to a finer simulation: docs/history/surface.md.)
void leaf_normals(const sim::AdaptiveMesh& mesh, const std::vector<Vec4f>& x, std::vector<Vec4f>& normals);

// The root edge whose curve a new vertex lies on; none for a base vertex.
sim::EdgeId root_of(const CurvedSurface& surface, sim::VertexId v);

// Brings every leaf to this level and all new vertices onto their curves. Pre: 0 <= level <= max_level.
sim::AdaptReport set_surface_level(CurvedSurface& surface, int level);

// Rebuilds the plan for the present mesh. Call after every adaptation that changed the mesh.
void plan_surface(CurvedSurface& surface);

// The mesh's observer during an adaptation: keeps the surface's arrays consistent with the mesh.
class SurfaceObserver {
 public:
    // Where a new vertex starts: at its edge's midpoint or on its curve.
    enum class SpawnPosition { Middle, Curve };
    SurfaceObserver(CurvedSurface& surface, SpawnPosition position) : surface_(surface), spawn_(position) {}

    void on_capacity(std::size_t capacity);
    void on_split(sim::VertexId c, sim::VertexId a, sim::VertexId b);
    void on_rejoin(sim::VertexId) {}
    void before(sim::TriangleId) {}
    void after(sim::TriangleId t);

 private:
    CurvedSurface& surface_;
    SpawnPosition spawn_;
};

// Keeps the drawn surface out of the body: where the cloth lies on the body, a curve or the chord of a new edge may lie
// below the offset surface; its vertices are moved out to the offset surface.

// Lives for one update. It queries the body once for each base vertex, and for other vertices only if they may be too
// near.
class Lift {
 public:
    // Pre: the surface's base vertices are at their new positions. Uses surface.clear as scratch memory.
    Lift(CurvedSurface& surface, const MoveOptions& options);

    // The position of a new vertex: `where`, or moved out to the offset surface if `where` is nearer to the body or
    // inside.
    Vec4f lifted(const SurfacePlan::Point& point, const Vec4f& where) const;

    // The vertex was placed `distance` (m) away from its lifted position, so it may be that much nearer to the body.
    void note_moved(sim::VertexId v, float distance) const {
        if (body_ != nullptr) surface_.clear[v.value] -= distance;
    }

 private:
    CurvedSurface& surface_;
    const sim::Collider* body_;
    float offset_;  // m
};

}  // namespace selvedge::render
