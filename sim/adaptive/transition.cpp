// Retriangulation: how a triangle passes from one configuration to another.  (thesis 3.3; SPEC 1.2)
#include <algorithm>
#include <utility>

#include "sim/adaptive/adaptive_mesh.h"

namespace selvedge {

// What surrounds and fills one triangle, by the local numbers of configuration.h. Midpoints and children of unsplit
// edges are none.
struct AdaptiveMesh::Stencil {
    std::array<VertexId, kLocalPoints> points;
    std::array<Vec2f, kLocalPoints> u;
    std::array<EdgeId, kLocalEdges> edges;
};

int AdaptiveMesh::retriangulate(int level, TransitionCounts* counts) {
    // Coarsening undoes a refinement last to first, so that ids come back in the order in which they were taken.
    if (!rejoining_.empty()) std::reverse(marked_.begin(), marked_.end());
    int transitions = 0;
    for (const TriangleId id : marked_) {
        AdaptiveTriangle& t = triangles_[id];
        SELVEDGE_ASSERT(t.level == level);
        t.marked = false;
        const Configuration from = t.configuration, to = least_work(from, split_mask(t));
        if (from == to) continue;
        change_configuration(id, to);
        if (counts != nullptr) ++counts->by_configuration[index_of(from)][index_of(to)];
        ++transitions;
    }
    marked_.clear();
    release_rejoined();
    changed_from_ = std::min(changed_from_, level);
    list_level(static_cast<std::size_t>(level));
    list_level(static_cast<std::size_t>(level) + 1);
    return transitions;
}

SplitMask AdaptiveMesh::split_mask(const AdaptiveTriangle& t) const {
    unsigned mask = 0;
    for (std::size_t k = 0; k < 3; ++k) mask |= is_split(t.edges[k]) ? 1U << k : 0U;
    return static_cast<SplitMask>(mask);
}

void AdaptiveMesh::change_configuration(TriangleId id, Configuration to) {
    AdaptiveTriangle& owner = triangles_[id];
    const Configuration from = owner.configuration;
    if (from == to) return;
    const Transition& plan = transition(from, to);
    if (from == Configuration::C0) unlink(id);
    drop_unshared(owner, plan);
    keep_shared(owner, plan);
    owner.configuration = to;
    create_missing(owner);
    if (to == Configuration::C0) link(id);
}

void AdaptiveMesh::drop_unshared(const AdaptiveTriangle& owner, const Transition& plan) {
    for (std::size_t i = plan.drops_triangle.size(); i-- > 0;) {
        if (!plan.drops_triangle[i]) continue;
        const TriangleId dropped = owner.internal_triangles[i];
        unlink(dropped);
        set_sides(dropped, TriangleId{});
        triangles_.release(dropped);
    }
    for (std::size_t i = plan.drops_edge.size(); i-- > 0;) {
        if (plan.drops_edge[i]) edges_.release(owner.internal_edges[i]);
    }
}

void AdaptiveMesh::keep_shared(AdaptiveTriangle& owner, const Transition& plan) const {
    const auto old_triangles = owner.internal_triangles;
    const auto old_edges = owner.internal_edges;
    for (std::size_t i = 0; i < plan.triangle_from.size(); ++i) {
        const std::uint8_t from = plan.triangle_from[i];
        owner.internal_triangles[i] = from == kNoSlot ? TriangleId{} : old_triangles[from];
    }
    for (std::size_t i = 0; i < plan.edge_from.size(); ++i) {
        const std::uint8_t from = plan.edge_from[i];
        owner.internal_edges[i] = from == kNoSlot ? EdgeId{} : old_edges[from];
    }
}

void AdaptiveMesh::create_missing(AdaptiveTriangle& owner) {
    const Layout& inside = layout(owner.configuration);
    Stencil stencil = stencil_of(owner);
    for (std::size_t i = 0; i < inside.edge_count; ++i) {
        EdgeId& edge = owner.internal_edges[i];
        if (!edge) edge = create_internal_edge(owner, inside.edges[i], stencil);
        stencil.edges[kFirstInternalEdge + i] = edge;
    }
    for (std::size_t i = 0; i < inside.triangle_count; ++i) {
        TriangleId& triangle = owner.internal_triangles[i];
        if (!triangle) triangle = create_internal_triangle(owner, inside.triangles[i], stencil);
        triangles_[triangle].regular = owner.configuration == Configuration::C10;
    }
}

AdaptiveMesh::Stencil AdaptiveMesh::stencil_of(const AdaptiveTriangle& owner) const {
    Stencil stencil;
    for (std::size_t k = 0; k < 3; ++k) {
        const AdaptiveEdge& external = edges_[owner.edges[k]];
        const bool runs_along = external.ends[0] == owner.vertices[k];
        stencil.points[k] = owner.vertices[k];
        stencil.points[3 + k] = external.centre;
        stencil.u[k] = owner.u[k];
        stencil.u[3 + k] = 0.5F * (owner.u[k] + owner.u[(k + 1) % 3]);
        stencil.edges[k] = owner.edges[k];
        stencil.edges[3 + 2 * k] = external.children[runs_along ? 0 : 1];
        stencil.edges[4 + 2 * k] = external.children[runs_along ? 1 : 0];
    }
    return stencil;
}

EdgeId AdaptiveMesh::create_internal_edge(const AdaptiveTriangle& owner, const InternalEdge& drawn,
                                          const Stencil& stencil) {
    AdaptiveEdge edge;
    edge.ends = {stencil.points[drawn.points[0]], stencil.points[drawn.points[1]]};
    edge.rest_length = (stencil.u[drawn.points[1]] - stencil.u[drawn.points[0]]).norm();
    edge.level = static_cast<std::uint8_t>(owner.level + 1);
    return edges_.create(edge);
}

TriangleId AdaptiveMesh::create_internal_triangle(const AdaptiveTriangle& owner, const InternalTriangle& drawn,
                                                  const Stencil& stencil) {
    AdaptiveTriangle triangle;
    triangle.panel = owner.panel;
    triangle.level = static_cast<std::uint8_t>(owner.level + 1);
    for (std::size_t k = 0; k < 3; ++k) {
        triangle.vertices[k] = stencil.points[drawn.points[k]];
        triangle.u[k] = stencil.u[drawn.points[k]];
        triangle.edges[k] = stencil.edges[drawn.edges[k]];
    }
    const TriangleId id = triangles_.create(triangle);
    set_sides(id, id);
    link(id);
    return id;
}

// An external edge that is left whole lies one level above the internal triangle and keeps the owner as its side.
void AdaptiveMesh::set_sides(TriangleId id, TriangleId value) {
    const AdaptiveTriangle& t = triangles_[id];
    for (std::size_t k = 0; k < 3; ++k) {
        AdaptiveEdge& edge = edges_[t.edges[k]];
        if (edge.level == t.level) edge.sides[edge.ends[0] == t.vertices[k] ? 0 : 1] = value;
    }
}

TriangleId& AdaptiveMesh::next_at(TriangleId t, VertexId v) {
    AdaptiveTriangle& triangle = triangles_[t];
    return triangle.next[corner_at(triangle, v)];
}

void AdaptiveMesh::link(TriangleId id) {
    for (const VertexId v : triangles_[id].vertices) {
        TriangleId* place = &vertices_[v].first_triangle;
        while (*place < id) place = &next_at(*place, v);  // none is greater than any id
        next_at(id, v) = *place;
        *place = id;
    }
}

void AdaptiveMesh::unlink(TriangleId id) {
    for (const VertexId v : triangles_[id].vertices) {
        TriangleId* place = &vertices_[v].first_triangle;
        while (*place != id) place = &next_at(*place, v);
        *place = std::exchange(next_at(id, v), TriangleId{});
    }
}

}  // namespace selvedge
