#pragma once
// Creases: base edges at which the drawn surface stays sharp, such as a pressed fold. Along a crease the surface has
// one normal per side, and the crease's curve lies in the tangent planes of both sides.  (Vlachos et al. 2001, 4.2)
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

// Pre: mesh is at level 0; each edge is a base edge with a triangle on both sides.
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

}  // namespace selvedge::render
