#include "bench/thesis/pointer_transitions.h"

#include <map>
#include <utility>

namespace selvedge::bench {
namespace {

Vec2f material(const PointerTriangle& t, sim::LocalPoint p) {
    if (p < 3) return t.u[p];
    return 0.5F * (t.u[p - 3U] + t.u[(p - 2U) % 3U]);
}

// The side of the edge on which a triangle lies that has it from `start`.
std::size_t side_from(const PointerEdge& edge, const PointerVertex* start) {
    return edge.ends[0] == start ? 0 : 1;
}

void put_in(PointerTriangle& t) {
    for (std::size_t k = 0; k < 3; ++k) {
        t.vertices[k]->add(&t);
        t.edges[k]->sides[side_from(*t.edges[k], t.vertices[k])] = &t;
    }
}

void take_out(PointerTriangle& t) {
    for (std::size_t k = 0; k < 3; ++k) {
        t.vertices[k]->remove(&t);
        t.edges[k]->sides[side_from(*t.edges[k], t.vertices[k])] = nullptr;
    }
}

}  // namespace

PointerTransitions::PointerTransitions(const sim::GarmentMesh& base) {
    for (std::size_t v = 0; v < base.x.size(); ++v) vertices_.push_back(store_.make<PointerVertex>());
    std::map<std::pair<int, int>, PointerEdge*> edges;
    for (const sim::GarmentTriangle& source : base.triangles) {
        PointerTriangle t;
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = source.vertices[k], b = source.vertices[(k + 1) % 3];
            t.vertices[k] = vertices_[static_cast<std::size_t>(a)];
            t.u[k] = source.u[k].cast<float>();
            PointerEdge*& edge = edges[std::minmax(a, b)];
            if (edge == nullptr) {
                edge = store_.make<PointerEdge>();
                edge->ends = {t.vertices[k], vertices_[static_cast<std::size_t>(b)]};
                edge->rest_length = static_cast<float>((source.u[(k + 1) % 3] - source.u[k]).norm());
                edges_.push_back(edge);
            }
            t.edges[k] = edge;
        }
        triangles_.push_back({.triangle = t});
    }
    const std::size_t base_edges = edges_.size();
    for (std::size_t e = 0; e < base_edges; ++e) {
        PointerEdge* const edge = edges_[e];
        edge->centre = store_.make<PointerVertex>();
        vertices_.push_back(edge->centre);
        for (std::size_t half = 0; half < 2; ++half) {
            PointerEdge* const child = store_.make<PointerEdge>();
            child->ends = half == 0 ? std::array{edge->ends[0], edge->centre} : std::array{edge->centre, edge->ends[1]};
            child->rest_length = 0.5F * edge->rest_length;
            child->level = 1;
            edge->children[half] = child;
            edges_.push_back(child);
        }
    }
}

PointerTransitions::~PointerTransitions() {
    for (PointerEdge* e : edges_) store_.drop(e);
    for (PointerVertex* v : vertices_) store_.drop(v);
}

void PointerTransitions::configure_all(sim::Configuration to) {
    for (Parent& parent : triangles_) configure(parent, to);
}

void PointerTransitions::clear_all() {
    for (Parent& parent : triangles_) clear(parent);
}

std::size_t PointerTransitions::adjacency_count() const {
    std::size_t count = 0;
    for (const PointerVertex* v : vertices_) count += static_cast<std::size_t>(v->triangle_count);
    return count;
}

PointerVertex* PointerTransitions::point(const PointerTriangle& t, sim::LocalPoint p) const {
    return p < 3 ? t.vertices[p] : t.edges[p - 3U]->centre;
}

PointerEdge* PointerTransitions::edge(const PointerTriangle& t, sim::LocalEdge e) const {
    if (e < 3) return t.edges[e];
    if (e >= sim::kFirstInternalEdge) return t.internal_edges[e - sim::kFirstInternalEdge];
    const std::size_t k = (e - 3U) / 2U, half = (e - 3U) % 2U;
    const PointerEdge& parent = *t.edges[k];
    return parent.children[parent.ends[0] == t.vertices[k] ? half : 1 - half];
}

void PointerTransitions::configure(Parent& parent, sim::Configuration to) {
    PointerTriangle& t = parent.triangle;
    parent.configuration = to;
    if (to == sim::Configuration::C0) return put_in(t);
    const sim::Layout& inside = layout(to);
    for (std::size_t i = 0; i < inside.edge_count; ++i) {
        const auto& [a, b] = inside.edges[i].points;
        PointerEdge* const made = store_.make<PointerEdge>();
        made->ends = {point(t, a), point(t, b)};
        made->rest_length = (material(t, b) - material(t, a)).norm();
        made->level = t.level + 1;
        t.internal_edges[i] = made;
    }
    for (std::size_t i = 0; i < inside.triangle_count; ++i) {
        PointerTriangle* const made = store_.make<PointerTriangle>();
        for (std::size_t k = 0; k < 3; ++k) {
            made->vertices[k] = point(t, inside.triangles[i].points[k]);
            made->edges[k] = edge(t, inside.triangles[i].edges[k]);
            made->u[k] = material(t, inside.triangles[i].points[k]);
        }
        made->level = t.level + 1;
        put_in(*made);
        t.internal_triangles[i] = made;
    }
}

void PointerTransitions::clear(Parent& parent) {
    PointerTriangle& t = parent.triangle;
    if (parent.configuration == sim::Configuration::C0) return take_out(t);
    const sim::Layout& inside = layout(parent.configuration);
    for (std::size_t i = inside.triangle_count; i-- > 0;) {
        take_out(*t.internal_triangles[i]);
        store_.drop(std::exchange(t.internal_triangles[i], nullptr));
    }
    for (std::size_t i = inside.edge_count; i-- > 0;) store_.drop(std::exchange(t.internal_edges[i], nullptr));
}

}  // namespace selvedge::bench
