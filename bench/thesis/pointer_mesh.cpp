#include "bench/thesis/pointer_mesh.h"

#include <map>
#include <utility>

#include "sim/core/assert.h"

namespace selvedge::bench {

template <class Store>
PointerMesh<Store>::PointerMesh(const sim::GarmentMesh& base) : levels_(1), vertex_count_(base.x.size()) {
    for (std::size_t v = 0; v < base.x.size(); ++v) base_vertices_.push_back(store_.template make<PointerVertex>());
    std::map<std::pair<int, int>, PointerEdge*> edges;
    for (const sim::GarmentTriangle& source : base.triangles) {
        auto* const t = store_.template make<PointerTriangle>();
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = source.vertices[k], b = source.vertices[(k + 1) % 3];
            t->vertices[k] = base_vertices_[static_cast<std::size_t>(a)];
            t->u[k] = source.u[k].template cast<float>();
            PointerEdge*& edge = edges[std::minmax(a, b)];
            if (edge == nullptr) {
                const auto length = static_cast<float>((source.u[(k + 1) % 3] - source.u[k]).norm());
                edge = make_edge(t->vertices[k], base_vertices_[static_cast<std::size_t>(b)], length, 0);
                levels_[0].edges.push_back(edge);
            }
            t->edges[k] = edge;
            edge->sides[edge->ends[0] == t->vertices[k] ? 0 : 1] = t;
            t->vertices[k]->add(t);
        }
        levels_[0].triangles.push_back(t);
    }
}

template <class Store>
PointerMesh<Store>::~PointerMesh() {
    while (level() > 0) coarsen();
    for (PointerTriangle* t : levels_[0].triangles) store_.drop(t);
    for (PointerEdge* e : levels_[0].edges) store_.drop(e);
    for (PointerVertex* v : base_vertices_) store_.drop(v);
}

template <class Store>
std::size_t PointerMesh<Store>::edge_count() const {
    std::size_t count = 0;
    for (const Level& level : levels_) count += level.edges.size();
    return count;
}

template <class Store>
std::size_t PointerMesh<Store>::triangle_count() const {
    std::size_t count = 0;
    for (const Level& level : levels_) count += level.triangles.size();
    return count;
}

template <class Store>
void PointerMesh<Store>::refine() {
    Level finer;
    Level& last = levels_.back();
    finer.edges.reserve(2 * last.edges.size() + 3 * last.triangles.size());
    finer.triangles.reserve(4 * last.triangles.size());
    for (PointerEdge* edge : last.edges) split(edge, finer);
    for (PointerTriangle* t : last.triangles) fill(t, finer);
    vertex_count_ += last.edges.size();
    levels_.push_back(std::move(finer));
}

template <class Store>
void PointerMesh<Store>::coarsen() {
    SELVEDGE_ASSERT(level() > 0);
    levels_.pop_back();
    Level& last = levels_.back();
    for (std::size_t i = last.triangles.size(); i-- > 0;) clear(last.triangles[i]);
    for (std::size_t i = last.edges.size(); i-- > 0;) {
        PointerEdge* const edge = last.edges[i];
        store_.drop(edge->children[1]);
        store_.drop(edge->children[0]);
        store_.drop(std::exchange(edge->centre, nullptr));
    }
    vertex_count_ -= last.edges.size();
}

template <class Store>
PointerEdge* PointerMesh<Store>::make_edge(PointerVertex* a, PointerVertex* b, float rest_length, int level) {
    auto* const edge = store_.template make<PointerEdge>();
    edge->ends = {a, b};
    edge->rest_length = rest_length;
    edge->level = level;
    return edge;
}

template <class Store>
void PointerMesh<Store>::split(PointerEdge* edge, Level& finer) {
    edge->centre = store_.template make<PointerVertex>();
    const float half = 0.5F * edge->rest_length;
    edge->children[0] = make_edge(edge->ends[0], edge->centre, half, edge->level + 1);
    edge->children[1] = make_edge(edge->centre, edge->ends[1], half, edge->level + 1);
    finer.edges.insert(finer.edges.end(), edge->children.begin(), edge->children.end());
}

//            V2           Child k is at Vk: (Vk, Mk, Mk+2). Child 3 is (M0, M1, M2). Internal edge k is opposite
//           /  \          Vk: it joins Mk and Mk+2.
//         M2----M1
//         / \  / \        .
//       V0---M0---V1
template <class Store>
void PointerMesh<Store>::fill(PointerTriangle* parent, Level& finer) {
    std::array<PointerVertex*, 3> m;
    std::array<Vec2f, 3> mu{Vec2f::Zero(), Vec2f::Zero(), Vec2f::Zero()};
    for (std::size_t k = 0; k < 3; ++k) {
        parent->vertices[k]->remove(parent);
        m[k] = parent->edges[k]->centre;
        mu[k] = 0.5F * (parent->u[k] + parent->u[(k + 1) % 3]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t l = (k + 2) % 3;
        parent->internal_edges[k] = make_edge(m[k], m[l], (mu[k] - mu[l]).norm(), parent->level + 1);
        finer.edges.push_back(parent->internal_edges[k]);
    }
    // The half of edge k that ends at corner c of the parent.
    const auto half = [&](std::size_t k, std::size_t c) {
        const PointerEdge* const edge = parent->edges[k];
        return edge->children[edge->ends[0] == parent->vertices[c] ? 0 : 1];
    };
    for (std::size_t k = 0; k < 4; ++k) {
        auto* const t = store_.template make<PointerTriangle>();
        const std::size_t l = (k + 2) % 3;
        t->level = parent->level + 1;
        if (k < 3) {
            t->vertices = {parent->vertices[k], m[k], m[l]};
            t->u = {parent->u[k], mu[k], mu[l]};
            t->edges = {half(k, k), parent->internal_edges[k], half(l, k)};
        } else {
            t->vertices = m;
            t->u = mu;
            t->edges = {parent->internal_edges[1], parent->internal_edges[2], parent->internal_edges[0]};
        }
        for (std::size_t c = 0; c < 3; ++c) {
            t->vertices[c]->add(t);
            t->edges[c]->sides[t->edges[c]->ends[0] == t->vertices[c] ? 0 : 1] = t;
        }
        parent->internal_triangles[k] = t;
        finer.triangles.push_back(t);
    }
}

template <class Store>
void PointerMesh<Store>::clear(PointerTriangle* parent) {
    for (std::size_t k = 4; k-- > 0;) {
        PointerTriangle* const t = std::exchange(parent->internal_triangles[k], nullptr);
        for (PointerVertex* v : t->vertices) v->remove(t);
        store_.drop(t);
    }
    for (std::size_t k = 3; k-- > 0;) store_.drop(std::exchange(parent->internal_edges[k], nullptr));
    for (PointerVertex* v : parent->vertices) v->add(parent);
}

template class PointerMesh<NewDelete>;
template class PointerMesh<Pools>;
template class PointerMesh<ListPools>;

}  // namespace selvedge::bench
