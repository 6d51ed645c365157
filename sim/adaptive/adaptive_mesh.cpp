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
    const std::uint8_t slot = layout(t.configuration).slot_at_unsplit[place_of(t, e)];
    return slot == kNoSlot ? TriangleId{} : t.internal_triangles[slot];
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
    // One that is marked has let another edge go in this pass.
    const auto lets_go = [&](TriangleId side) { return !side || triangles_[side].marked || has_leaf_children(side); };
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

// That both sides are regular is looked at when they are retriangulated.
VertexId AdaptiveMesh::split(EdgeId e) {
    AdaptiveEdge& edge = edges_[e];
    SELVEDGE_ASSERT(!edge.centre && edge.level < options_.max_level);
    const VertexId centre = vertices_.take<1>()[0];
    edge.children = edges_.take<2>();
    edge.centre = centre;
    grow_lists_with_pools();
    const auto level = static_cast<std::uint8_t>(edge.level + 1);
    const float half = 0.5F * edge.rest_length;
    edges_[edge.children[0]].set({edge.ends[0], centre}, {}, half, level);
    edges_[edge.children[1]].set({centre, edge.ends[1]}, {}, half, level);
    vertices_[centre] = {.parent = e, .level = level};
    splitting_.push_back(e);
    mark_sides(e);
    return centre;
}

// That no child of the sides is refined is looked at when they are retriangulated.
void AdaptiveMesh::rejoin(EdgeId e) {
    SELVEDGE_ASSERT(is_split(e) && has_leaf_children(e));
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

// Last to first, so that none moves when all of a level were split.
void AdaptiveMesh::list_split() {
    for (std::size_t i = splitting_.size(); i-- > 0;) {
        levels_.remove_unsplit(edges_[splitting_[i]].level, splitting_[i]);
    }
    for (const EdgeId e : splitting_) {
        const AdaptiveEdge& edge = edges_[e];
        levels_.add_split(edge.level, e);
        for (const EdgeId child : edge.children) levels_.add_unsplit(edge.level + 1, child);
        keeper_.note(e);
    }
    splitting_.clear();
}

// In the reverse order of split(), so that splitting again finds the same ids.
void AdaptiveMesh::release_rejoined() {
    for (; !rejoining_.empty(); rejoining_.pop_back()) {
        const EdgeId e = rejoining_.back();
        AdaptiveEdge& edge = edges_[e];
        for (std::size_t i = 2; i-- > 0;) {
            levels_.remove_unsplit(edge.level + 1, edge.children[i]);
            keeper_.note_released(edge.children[i]);
            edges_.release(edge.children[i]);
        }
        levels_.remove_split(edge.level, e);
        levels_.add_unsplit(edge.level, e);
        keeper_.note_released(edge.centre);
        keeper_.note(e);
        vertices_.release(edge.centre);
        edge.children = {};
        edge.centre = {};
        edge.rejoining = false;
    }
}

void AdaptiveMesh::grow_lists() {
    levels_.grow(edges_.capacity(), triangles_.capacity());
    keeper_.grow(vertices_.capacity(), edges_.capacity(), triangles_.capacity());
    listed_capacity_ = vertices_.capacity() + edges_.capacity() + triangles_.capacity();
}

// A base vertex knows with which base triangle its fan starts; a centre lies on an edge, and the triangles beside the
// child edges border it. What was split in this pass has no sides yet and is passed over.
TriangleId AdaptiveMesh::first_at(VertexId v, std::size_t fan) const {
    if (v.value < base_vertices_) {
        const std::size_t place = fan_starts_[v.value] + fan;
        return place < fan_starts_[v.value + 1] ? first_inside(fans_[place], v) : TriangleId{};
    }
    if (fan > 0) return {};
    const AdaptiveEdge& parent = edges_[vertices_[v].parent];
    const std::size_t child = parent.sides[0] ? 1 : 0, side = 1 - child;  // the side that the child has on its left
    EdgeId e = parent.children[child];
    while (edges_[e].centre && edges_[edges_[e].children[1 - child]].sides[side]) e = edges_[e].children[1 - child];
    return leaf_at(e, static_cast<int>(side));
}

TriangleId AdaptiveMesh::first_inside(TriangleId owner, VertexId v) const {
    while (!is_leaf(triangles_[owner])) {
        const AdaptiveTriangle& t = triangles_[owner];
        owner = t.internal_triangles[layout(t.configuration).slot_at_corner[corner_at(t, v)]];
    }
    return owner;
}

TriangleId AdaptiveMesh::next_at(VertexId v, TriangleId id) const {
    const AdaptiveTriangle& t = triangles_[id];
    const std::size_t before = (corner_at(t, v) + 2) % 3;
    const EdgeId e = t.edges[before];
    return leaf_at(e, edges_[e].ends[0] == t.vertices[before] ? 1 : 0);
}

}  // namespace selvedge
