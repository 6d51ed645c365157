#pragma once
// Back-face coarsening: where the cloth's right side is turned away from the viewer, nothing needs to be fine. The band
// in which fine passes into coarse lies wholly on the side that is not seen.  (thesis 5; SPEC 1.3)
//
// An edge that does not split keeps the triangles beside it coarse, and by the permissions also holds back its
// neighbours' finer edges: at most one ring of triangles of the edge's own level. So an edge is vetoed only when all
// triangles of its level that touch its two triangles are hidden; a triangle is hidden when none of its leaves is seen.
#include <cstdint>
#include <vector>

#include "sim/adaptive/adaptive_mesh.h"
#include "sim/core/math.h"

namespace selvedge::sim {

struct ViewPoint {
    Vec3f eye = Vec3f::UnitZ();  // where the viewer stands, m; orthographic: unit vector from the cloth to the viewer
    bool is_orthographic = false;
};

struct BackFaceOptions {
    float split_margin = 0.10F;   // rad beyond the silhouette that still count as seen: no split is refused there
    float rejoin_margin = 0.25F;  // above split_margin: no rejoin is forced there, so that nothing flickers
};

// What is seen of a mesh. Part of the state that the adaptation's observer keeps: pass its calls on.
class Visibility {
 public:
    explicit Visibility(const ViewPoint& view, const BackFaceOptions& options = {});

    void move_to(const ViewPoint& view) { view_ = view; }

    // Looks at all leaves; before each adaptation. A leaf counts as seen when its plane or the normal of one of its
    // vertices is. Position is any vector type whose first three coefficients are the position, m;
    // Normal, unit, likewise.
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
    // The triangles round the new centre lie within those that touch both a and b.
    void on_split(VertexId c, VertexId a, VertexId b) {
        seen_levels_[c.value] = seen_levels_[a.value] & seen_levels_[b.value];
    }

    // Whether all triangles of the edge's level round its two triangles are hidden.
    bool is_hidden(const AdaptiveMesh& mesh, EdgeId e) const;

 private:
    // Bit 0: seen, or within the split margin; bit 1: within the rejoin margin.
    using Seen = std::uint8_t;
    static constexpr Seen kWhollySeen = 3;

    void start(const AdaptiveMesh& mesh);
    Seen seen(float facing) const {
        return static_cast<Seen>((facing > least_facing_split_ ? 1 : 0) | (facing > least_facing_rejoin_ ? 2 : 0));
    }
    Seen seen_plane(const std::array<Vec3f, 3>& x) const;
    float facing(const Vec3f& at, const Vec3f& normal) const;
    void pass_up(const AdaptiveMesh& mesh);
    void mark_leaf(const LeafTriangle& leaf, Seen how);
    void mark_corners(const std::array<VertexId, 3>& corners, Seen how, std::uint32_t levels);

    ViewPoint view_;
    float least_facing_split_;  // cosine between normal and direction to the viewer
    float least_facing_rejoin_;
    std::vector<Seen> vertex_seen_;  // by vertex id
    std::vector<Seen> leaf_seen_;    // by triangle id, parents too
    // By vertex id: bit l is set when a triangle of level l at this vertex is seen, or a leaf above level l; the same
    // for the rejoin margin 16 bits higher.
    std::vector<std::uint32_t> seen_levels_;
};

struct BackFaceCriterion {
    static constexpr bool is_veto = true;
    const Visibility* visibility;

    bool vetoes(const AdaptiveMesh& mesh, EdgeId e) const { return visibility->is_hidden(mesh, e); }
};

}  // namespace selvedge::sim
