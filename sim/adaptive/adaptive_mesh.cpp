#include "sim/adaptive/adaptive_mesh.h"

#include <algorithm>

namespace selvedge {

std::uint64_t TransitionCounts::between_states(std::size_t from, std::size_t to) const {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < kConfigurations; ++i) {
        for (std::size_t j = 0; j < kConfigurations; ++j) {
            const auto a = static_cast<Configuration>(i), b = static_cast<Configuration>(j);
            if (state_of(a) == from && state_of(b) == to) sum += by_configuration[i][j];
        }
    }
    return sum;
}

TriangleId AdaptiveMesh::leaf_at(EdgeId e, int side) const {
    const TriangleId owner = edges_[e].sides[static_cast<std::size_t>(side)];
    if (!owner) return owner;
    const AdaptiveTriangle& t = triangles_[owner];
    if (is_leaf(t)) return owner;
    return t.internal_triangles[layout(t.configuration).slot_at_unsplit[place_of(t, e)]];
}

// Sides name triangles at the edge's own level, so that the internal triangle of an irregular S1..S6 owner, which
// borders the same edge one level deeper, never stands in the way of S1 -> S4 or S1 -> S7.
bool AdaptiveMesh::may_split(EdgeId e) const {
    const AdaptiveEdge& edge = edges_[e];
    const auto is_regular = [&](TriangleId side) { return !side || triangles_[side].regular; };
    return !edge.centre && edge.level < options_.max_level && is_regular(edge.sides[0]) && is_regular(edge.sides[1]);
}

bool AdaptiveMesh::may_rejoin(EdgeId e) const {
    if (!is_split(e) || !has_leaf_children(e)) return false;
    const auto lets_go = [&](TriangleId side) { return !side || has_leaf_children(side); };
    return lets_go(edges_[e].sides[0]) && lets_go(edges_[e].sides[1]);
}

bool AdaptiveMesh::has_leaf_children(EdgeId e) const {
    const std::array<EdgeId, 2>& children = edges_[e].children;
    return !edges_[children[0]].centre && !edges_[children[1]].centre;
}

// The three internal edges and the six child edges of an S7 triangle are the edges of its four children: none of them
// is split when all four are leaves. In the other states internal triangles always are.
bool AdaptiveMesh::has_leaf_children(TriangleId t) const {
    const AdaptiveTriangle& owner = triangles_[t];
    if (owner.configuration != Configuration::C10) return true;
    const auto is_whole = [&](TriangleId child) { return is_leaf(triangles_[child]); };
    return std::all_of(owner.internal_triangles.begin(), owner.internal_triangles.end(), is_whole);
}

VertexId AdaptiveMesh::split(EdgeId e) {
    SELVEDGE_ASSERT(may_split(e));
    AdaptiveEdge& edge = edges_[e];
    AdaptiveEdge child;
    child.rest_length = 0.5F * edge.rest_length;
    child.level = static_cast<std::uint8_t>(edge.level + 1);
    edge.centre = vertices_.create({.first_triangle = {}, .level = child.level});
    for (std::size_t i = 0; i < 2; ++i) {
        child.ends = i == 0 ? std::array{edge.ends[0], edge.centre} : std::array{edge.centre, edge.ends[1]};
        edge.children[i] = edges_.create(child);
    }
    mark_sides(e);
    return edge.centre;
}

void AdaptiveMesh::rejoin(EdgeId e) {
    SELVEDGE_ASSERT(may_rejoin(e));
    edges_[e].rejoining = true;
    rejoining_.push_back(e);
    mark_sides(e);
}

void AdaptiveMesh::mark_sides(EdgeId e) {
    for (const TriangleId side : edges_[e].sides) {
        if (!side || triangles_[side].marked) continue;
        triangles_[side].marked = true;
        marked_.push_back(side);
    }
}

// In the reverse order of split(), so that splitting again finds the same ids.
void AdaptiveMesh::release_rejoined() {
    for (; !rejoining_.empty(); rejoining_.pop_back()) {
        AdaptiveEdge& edge = edges_[rejoining_.back()];
        edges_.release(edge.children[1]);
        edges_.release(edge.children[0]);
        vertices_.release(edge.centre);
        edge.children = {};
        edge.centre = {};
        edge.rejoining = false;
    }
}

// The lists of one level follow from those of the level above.
void AdaptiveMesh::list_level(std::size_t level) {
    Level& own = levels_[level];
    own.unsplit.clear();
    own.split.clear();
    own.leaves.clear();
    own.refined.clear();
    if (level == 0) {
        for (std::uint32_t e = 0; e < base_edges_; ++e) list(EdgeId(e), own);
        for (std::uint32_t t = 0; t < base_triangles_; ++t) list(TriangleId(t), own);
        return;
    }
    const Level& above = levels_[level - 1];
    for (const EdgeId e : above.split) {
        for (const EdgeId child : edges_[e].children) list(child, own);
    }
    for (const TriangleId t : above.refined) {
        const AdaptiveTriangle& owner = triangles_[t];
        const Layout& inside = layout(owner.configuration);
        for (std::size_t i = 0; i < inside.edge_count; ++i) list(owner.internal_edges[i], own);
        for (std::size_t i = 0; i < inside.triangle_count; ++i) list(owner.internal_triangles[i], own);
    }
}

void AdaptiveMesh::list(EdgeId e, Level& into) const {
    (is_split(e) ? into.split : into.unsplit).push_back(e);
}

void AdaptiveMesh::list(TriangleId t, Level& into) const {
    (is_leaf(triangles_[t]) ? into.leaves : into.refined).push_back(t);
}

void AdaptiveMesh::refresh_lists() {
    if (changed_from_ > max_level()) return;
    for (int level = changed_from_; level <= max_level(); ++level) list_level(static_cast<std::size_t>(level));
    gather_leaves(*this, leaves_);
    changed_from_ = max_level() + 1;
}

}  // namespace selvedge
