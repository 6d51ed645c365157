#pragma once
// The surface that is drawn: the coarse cloth's triangles as the base of an adaptive mesh of its own, each new vertex
// on the curve of a root edge.  (thesis ch. 6; SPEC 5)
//
// A root edge is an edge of the base, or one inside a refined triangle. Vertices on it stand on its curve, at t =
// i/2^k, whatever has been split since; the ends of a root edge are older than it. So curves are made level by level,
// each vertex is evaluated once, and none moves because another comes or goes.
//
//   base edges -> their vertices -> edges inside triangles of level 0 -> their vertices -> ... of level 1 -> ...
#include <cstdint>
#include <span>
#include <vector>

#include "render/surface/creases.h"
#include "render/surface/edge_curve.h"
#include "sim/adaptive/adapt.h"
#include "sim/adaptive/adaptive_mesh.h"
#include "sim/core/math.h"
#include "sim/mesh/garment_mesh.h"

namespace selvedge::sim {
class Collider;
}

namespace selvedge::render {

struct SurfaceOptions {
    CurveModifier modifier{};
    int max_level = 3;
    std::vector<CreaseEdge> creases{};  // that stay sharp
};

// Where an edge lies on its root's curve, in steps of 1/2^max_level.
struct EdgePlace {
    sim::EdgeId root;
    std::uint16_t from = 0;
    std::uint16_t span = 0;
};

// What update_surface() goes through, level by level; made anew when the mesh has changed.
struct SurfacePlan {
    struct Curve {
        sim::VertexId a, b;
        float rest_length = 0;  // m
        sim::EdgeId root;
    };
    struct Point {
        sim::VertexId v;
        sim::VertexId a, b;       // ends of the edge whose centre it is
        std::uint32_t curve = 0;  // index
        std::uint32_t step = 0;   // t in steps of 1/2^max_level
    };
    std::vector<Curve> curves;
    std::vector<Point> points;
    std::vector<std::size_t> curve_ends, point_ends;  // by level: one past its last
    std::vector<std::uint32_t> curve_of;              // by EdgeId, of roots; scratch
};

struct CurvedSurface {
    sim::AdaptiveMesh mesh;
    CurveModifier modifier{};
    CurveWeights weights{0};

    // By VertexId, sized to the mesh's capacity; with a fourth 0.
    std::vector<Vec4f> x{};              // as drawn, m
    std::vector<Vec4f> normals{};        // unit, of the curves: what the ends' normals say
    std::vector<Vec4f> light_normals{};  // unit, of the triangles as drawn
    std::vector<float> shown{};          // 0: in the middle of its edge's ends, 1: on the curve
    std::vector<bool> is_leaving{};      // on its way to the middle, where it may go
    std::vector<EdgePlace> places{};     // by EdgeId

    Creases creases{};
    SurfacePlan plan{};
    std::vector<EdgeCurve> curves{};  // as the plan has them
    std::vector<float> clear{};       // m from the body, scratch
};

// At level 0: as the base is. Pre: base is sewn. Throws InputError as AdaptiveMesh does.
CurvedSurface make_curved_surface(const sim::GarmentMesh& base, const SurfaceOptions& options = {});

struct MoveOptions {
    const sim::Collider* body =
        nullptr;                    // that the surface must not dip into: vertices are lifted to its offset surface
    float offset = 0.003F;          // m, of that surface: the cloth's contacts'
    float longest_glide = 0.0002F;  // m that a vertex may glide to or from its edge's middle in one move
};

// Moves the surface to where the cloth is: one frame. x, normals: of the base's vertices, with a fourth 0; normals
// unit. A new vertex glides from the middle of its edge to its curve when the ends of the edge have arrived, one that
// is to go glides back (see adapt_surface.h), so that none jumps because of a change of level.
void update_surface(CurvedSurface& surface, std::span<const Vec4f> x, std::span<const Vec4f> normals,
                    const MoveOptions& options = {});

// The same in two: positions and curves' normals; then what the light needs. Interpolated normals hide the detail that
// the surface has, so they are made anew from its triangles, weighted by area.  (thesis fig. 6.6)
void move_surface(CurvedSurface& surface, std::span<const Vec4f> x, std::span<const Vec4f> normals,
                  const MoveOptions& options = {});
void update_light_normals(CurvedSurface& surface);

// Area-weighted normals of a mesh's leaves, by VertexId: what a coarse cloth gives the surface. (Other weights, and at
// hems normals that go on bending, came no nearer to a finer simulation: docs/measurements.md.)
void leaf_normals(const sim::AdaptiveMesh& mesh, const std::vector<Vec4f>& x, std::vector<Vec4f>& normals);

// The root edge on whose curve a new vertex stands; none for one of the base.
sim::EdgeId root_of(const CurvedSurface& surface, sim::VertexId v);

// Every leaf at that level, all new vertices where they belong. Pre: 0 <= level <= max_level.
sim::AdaptReport set_surface_level(CurvedSurface& surface, int level);

// The plan for the present mesh: after every adaptation that changed it.
void plan_surface(CurvedSurface& surface);

// Keeps the surface's arrays while an adaptation is under way.
class SurfaceObserver {
 public:
    // Where a new vertex starts.
    enum class SpawnPosition { Middle, Curve };
    SurfaceObserver(CurvedSurface& surface, SpawnPosition entrance) : surface_(surface), entrance_(entrance) {}

    void on_capacity(std::size_t capacity);
    void on_split(sim::VertexId c, sim::VertexId a, sim::VertexId b);
    void on_rejoin(sim::VertexId) {}
    void before(sim::TriangleId) {}
    void after(sim::TriangleId t);

 private:
    CurvedSurface& surface_;
    SpawnPosition entrance_;
};

// Keeps the drawn surface out of the body: where the cloth lies on it, a curve or the chord of a new edge may dip below
// the offset surface; its vertices are lifted back onto it.  (SPEC 5)

// For one update: asks the body once for each base vertex, and then only where a vertex may be too near.
class Lift {
 public:
    // The surface's base vertices are where they are to be. surface.clear is its memory.
    Lift(CurvedSurface& surface, const MoveOptions& options);

    // A vertex of an edge, moved to the offset surface if it was nearer to the body or inside, else `where`.
    Vec4f lifted(const SurfacePlan::Point& point, const Vec4f& where) const;

    // It stands so far, m, from where it was lifted to: so much nearer to the body it may be.
    void note_moved(sim::VertexId v, float distance) const {
        if (body_ != nullptr) surface_.clear[v.value] -= distance;
    }

 private:
    CurvedSurface& surface_;
    const sim::Collider* body_;
    float offset_;  // m
};

}  // namespace selvedge::render
