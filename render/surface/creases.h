#pragma once
// Folds that stay sharp, as a pressed crease does: along such edges of the base the surface has a normal on either
// side. The crease itself is the curve that lies in the tangent planes of both.  (SPEC 2, 5; Vlachos et al. 2001, 4.2)
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "render/surface/edge_curve.h"
#include "sim/adaptive/adaptive_mesh.h"
#include "sim/core/math.h"

namespace selvedge::render {

// Two vertices of the base that an edge joins.
using CreaseEdge = std::array<int, 2>;

// A vertex on a crease as it is seen from one side. At a base vertex a side is the smooth part of the triangles round
// it, numbered by one of their corners; at a new vertex it is 0 or 1, the crease's own.
using SidedVertex = std::pair<sim::VertexId, std::uint32_t>;

struct Creases {
    std::vector<bool> is_crease{};                            // by base EdgeId; empty: there are none
    std::vector<std::array<std::uint32_t, 3>> corner_side{};  // by base triangle
    std::vector<bool> is_creased{};                           // by base vertex
    std::vector<sim::TriangleId> base_of{};                   // by TriangleId: the base triangle that it lies in
    std::map<SidedVertex, Vec4f> normals{};                   // of curves, unit
    std::map<SidedVertex, Vec4f> light_normals{};             // of the triangles as drawn, unit

    bool empty() const { return is_crease.empty(); }
};

// Pre: mesh is at level 0; each edge is one of the base with a triangle at both sides.
Creases find_creases(const sim::AdaptiveMesh& mesh, std::span<const CreaseEdge> edges);

// When t has changed its configuration.
void note_children(Creases& creases, const sim::AdaptiveMesh& mesh, sim::TriangleId t);

// Sums of the areas of triangles by sided vertex, made unit: of the base's triangles, or of the leaves.
void update_base_normals(Creases& creases, const sim::AdaptiveMesh& mesh, const std::vector<Vec4f>& x);
// roots: by VertexId, as sided() asks for them.
void update_light_normals(Creases& creases, const sim::AdaptiveMesh& mesh, const std::vector<sim::EdgeId>& roots,
                          const std::vector<Vec4f>& x);

// root: of the curve that v stands on; of a base vertex, any. None where v lies on no crease.
std::optional<SidedVertex> sided(const Creases& creases, const sim::AdaptiveMesh& mesh, sim::VertexId v,
                                 sim::EdgeId root, sim::TriangleId base);

// The curve between two sides; its normals are those of the first.
EdgeCurve make_crease_curve(const CurveEnds& first, const CurveEnds& second, const CurveModifier& modifier);

}  // namespace selvedge::render
