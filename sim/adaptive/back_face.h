#pragma once
// Back-face coarsening: where the fabric's right side faces away from the viewer, the mesh may be coarse. The
// transition zone between fine and coarse lies entirely on the hidden side.  (thesis 5.5.1, figs. 5.7 and 5.8)
//
// An edge that is not split keeps the triangles beside it coarse. The permissions then also block finer edges of the
// neighbours, within at most one ring of triangles of the edge's own level. So an edge is vetoed only if all triangles
// of its level that touch its two triangles are hidden. A triangle is hidden if none of its leaves is visible.
#include <cstdint>
#include <vector>

#include "sim/adaptive/adaptive_mesh.h"
#include "sim/core/math.h"
#include "sim/core/view_point.h"

namespace selvedge::sim {

struct BackFaceOptions {
    float split_margin = 0.10F;   // rad beyond the silhouette that still count as visible: splits are not vetoed there
    float rejoin_margin = 0.25F;  // rad, above split_margin (hysteresis): rejoins are not forced there
};

// Which parts of a mesh are visible. The observer of the adaptation must forward on_capacity and on_split to it.
class Visibility {
 public:
    explicit Visibility(const ViewPoint& view, const BackFaceOptions& options = {});

    void move_to(const ViewPoint& view) { view_ = view; }

    // Evaluates all leaves; call it before each adaptation. A leaf counts as visible if its plane or the normal of one
    // of its vertices faces the viewer. Position is any vector type whose first three coefficients are the position, m;
    // likewise Normal, a unit vector.
    template <class Position, class Normal>
    void look(const AdaptiveMesh& mesh, const std::vector<Position>& x, const std::vector<Normal>& normals) {
        start(mesh);
        const auto at = [&](VertexId v) { return Vec3f(x[v.value].template head<3>()); };
        for (const VertexId v : mesh.leaf_vertices())
            vertex_seen_[v.value] = seen(facing(at(v), normals[v.value].template head<3>()));
        for (const LeafTriangle& leaf : mesh.leaf_triangles()) {
            Seen how = 0;
            for (const VertexId v : leaf.v) how |= vertex_seen_[v.value];
            if (how != kWhollySeen) how |= seen_plane({at(leaf.v[0]), at(leaf.v[1]), at(leaf.v[2])});
            mark_leaf(leaf, how);
        }
        pass_up(mesh);
    }

    void on_capacity(std::size_t vertices) { seen_levels_.resize(vertices, 0); }
    // The triangles round the new centre lie inside triangles that touch both a and b.
    void on_split(VertexId c, VertexId a, VertexId b) {
        seen_levels_[c.value] = seen_levels_[a.value] & seen_levels_[b.value];
    }

    // Whether the edge's two triangles, and all triangles of the same level that touch them, are hidden.
    bool is_hidden(const AdaptiveMesh& mesh, EdgeId e) const;

 private:
    // Bit 0: visible with the split margin; bit 1: visible with the rejoin margin.
    using Seen = std::uint8_t;
    static constexpr Seen kWhollySeen = 3;

    void start(const AdaptiveMesh& mesh);
    Seen seen(float facing) const {
        return static_cast<Seen>((facing > min_facing_split_ ? 1 : 0) | (facing > min_facing_rejoin_ ? 2 : 0));
    }
    Seen seen_plane(const std::array<Vec3f, 3>& x) const;
    float facing(const Vec3f& at, const Vec3f& normal) const;
    void pass_up(const AdaptiveMesh& mesh);
    void mark_leaf(const LeafTriangle& leaf, Seen how);
    void mark_corners(const std::array<VertexId, 3>& corners, Seen how, std::uint32_t levels);

    ViewPoint view_;
    float min_facing_split_;  // minimum cosine between normal and direction to the viewer
    float min_facing_rejoin_;
    std::vector<Seen> vertex_seen_;  // by vertex id
    std::vector<Seen> leaf_seen_;    // by triangle id, refined triangles included
    // By vertex id: bit l is set if a triangle of level l at this vertex, or a leaf coarser than level l, is visible.
    // Bits 16 and up: the same with the rejoin margin.
    std::vector<std::uint32_t> seen_levels_;
};

struct BackFaceCriterion {
    static constexpr bool is_veto = true;
    const Visibility* visibility;

    bool vetoes(const AdaptiveMesh& mesh, EdgeId e) const { return visibility->is_hidden(mesh, e); }
};

}  // namespace selvedge::sim
