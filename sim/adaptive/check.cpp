#include "sim/adaptive/check.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace selvedge::sim {
namespace {

// The elements that a traversal from the base elements reaches, and the leaves among them.
struct Reached {
    std::vector<int> vertices, edges, triangles;  // number of times reached, by id
    std::vector<VertexId> leaf_vertices;
    std::vector<EdgeId> leaf_edges;
    std::vector<TriangleId> leaf_triangles;
    bool is_sound = true;  // every link stayed inside its pool, and no element was reached twice
};

class Traversal {
 public:
    explicit Traversal(const AdaptiveMesh& mesh) : mesh_(mesh) {
        reached_.vertices.resize(mesh.vertices().capacity());
        reached_.edges.resize(mesh.edges().capacity());
        reached_.triangles.resize(mesh.triangles().capacity());
    }

    Reached run() {
        for (std::uint32_t i = 0; i < mesh_.base_vertex_count(); ++i) visit(VertexId(i));
        for (std::uint32_t i = 0; i < mesh_.base_edge_count(); ++i) visit(EdgeId(i));
        for (std::uint32_t i = 0; i < mesh_.base_triangle_count(); ++i) visit(TriangleId(i));
        return std::move(reached_);
    }

 private:
    template <class ElementId>
    bool enter(std::vector<int>& counts, ElementId id) {
        if (id.value >= counts.size() || counts[id.value] > 0) return reached_.is_sound = false;
        ++counts[id.value];
        return true;
    }

    void visit(VertexId v) {
        if (enter(reached_.vertices, v)) reached_.leaf_vertices.push_back(v);
    }

    void visit(EdgeId e) {
        if (!enter(reached_.edges, e)) return;
        const AdaptiveEdge& edge = mesh_.edge(e);
        if (!edge.centre) return reached_.leaf_edges.push_back(e);
        visit(edge.centre);
        for (const EdgeId child : edge.children) visit(child);
    }

    void visit(TriangleId t) {
        if (!enter(reached_.triangles, t)) return;
        const AdaptiveTriangle& triangle = mesh_.triangle(t);
        if (is_leaf(triangle)) return reached_.leaf_triangles.push_back(t);
        const Layout& inside = layout(triangle.configuration);
        for (std::size_t i = 0; i < inside.edge_count; ++i) visit(triangle.internal_edges[i]);
        for (std::size_t i = 0; i < inside.triangle_count; ++i) visit(triangle.internal_triangles[i]);
    }

    const AdaptiveMesh& mesh_;
    Reached reached_;
};

class Checker {
 public:
    explicit Checker(const AdaptiveMesh& mesh) : mesh_(mesh), reached_(Traversal(mesh).run()) {}

    std::vector<std::string> run() {
        expect(reached_.is_sound, "hierarchy: an element is reached twice or lies outside its pool");
        if (!reached_.is_sound) return std::move(problems_);
        check_pool("vertices", mesh_.vertices(), reached_.vertices);
        check_pool("edges", mesh_.edges(), reached_.edges);
        check_pool("triangles", mesh_.triangles(), reached_.triangles);
        for_each_reached<EdgeId>(reached_.edges, [&](EdgeId e) { check_edge(e); });
        for_each_reached<TriangleId>(reached_.triangles, [&](TriangleId t) { check_triangle(t); });
        check_conformity();
        check_adjacency();
        check_euler();
        check_area();
        check_lists();
        return std::move(problems_);
    }

 private:
    void expect(bool holds, std::string_view what) {
        if (!holds) problems_.emplace_back(what);
    }

    template <class ElementId>
    void expect(bool holds, std::string_view kind, ElementId id, std::string_view what) {
        if (holds) return;
        problems_.push_back(std::string(kind) + " " + std::to_string(id.value) + ": " + std::string(what));
    }

    template <class ElementId, class F>
    static void for_each_reached(const std::vector<int>& counts, F&& f) {
        for (std::uint32_t i = 0; i < counts.size(); ++i) {
            if (counts[i] > 0) f(ElementId(i));
        }
    }

    // Each id is either reached once or free once.
    template <class Pool>
    void check_pool(std::string_view name, const Pool& pool, std::vector<int> counts) {
        for (const auto id : pool.free_ids()) ++counts[id.value];
        const auto is_one = [](int n) { return n == 1; };
        expect(std::all_of(counts.begin(), counts.end(), is_one),
               std::string(name) + ": an id is leaked or freed alive");
    }

    void check_edge(EdgeId e) {
        const AdaptiveEdge& edge = mesh_.edge(e);
        expect(!edge.rejoining, "edge", e, "retriangulate() was not called");
        expect(edge.level <= mesh_.max_level(), "edge", e, "deeper than the maximum level");
        expect(edge.ends[0] != edge.ends[1], "edge", e, "its ends are one vertex");
        expect(edge.rest_length > 0.0F, "edge", e, "its rest length is not positive");
        for (std::size_t s = 0; s < 2; ++s) check_side(e, edge, s);
        check_orientation(e, edge);
        if (edge.centre) check_children(e, edge);
    }

    void check_side(EdgeId e, const AdaptiveEdge& edge, std::size_t s) {
        if (!edge.sides[s]) return;
        const AdaptiveTriangle& t = mesh_.triangle(edge.sides[s]);
        const std::size_t k = index_of(t, e);
        expect(reached_.triangles[edge.sides[s].value] > 0 && t.edges[k] == e, "edge", e, "a side is not its triangle");
        expect(t.level == edge.level, "edge", e, "a side is not at its level");
        const std::size_t first = edge.right_wrong ? 0 : s;
        expect(t.vertices[k] == edge.ends[first] && t.vertices[(k + 1) % 3] == edge.ends[1 - first], "edge", e,
               "runs the wrong way round a side");
    }

    // The surface's orientation changes between panels only at right_wrong edges, and stays the same there only at
    // cuts.
    void check_orientation(EdgeId e, const AdaptiveEdge& edge) {
        const bool has_both = edge.sides[0] && edge.sides[1];
        expect(!edge.right_wrong || (has_both && edge.sides[0] != edge.sides[1]), "edge", e,
               "is right_wrong without two sides");
        if (!has_both) return;
        const bool is_same = mesh_.triangle(edge.sides[0]).turned == mesh_.triangle(edge.sides[1]).turned;
        expect(edge.right_wrong || is_same, "edge", e, "the surface's orientation changes at an ordinary edge");
        if (!edge.right_wrong || !is_same) return;
        const auto is_on_cut = [&](VertexId v) { return mesh_.vertex(v).on_cut; };
        expect(mesh_.has_cuts() && is_on_cut(edge.ends[0]) && is_on_cut(edge.ends[1]), "edge", e,
               "is a cut, and its ends do not say so");
    }

    void check_children(EdgeId e, const AdaptiveEdge& edge) {
        expect(mesh_.vertex(edge.centre).level == edge.level + 1, "edge", e, "its centre has the wrong level");
        expect(mesh_.vertex(edge.centre).parent == e, "edge", e, "its centre has another parent");
        for (std::size_t i = 0; i < 2; ++i) {
            const AdaptiveEdge& child = mesh_.edge(edge.children[i]);
            expect(child.ends[i] == edge.ends[i] && child.ends[1 - i] == edge.centre, "edge", e,
                   "a child is elsewhere");
            expect(child.level == edge.level + 1, "edge", e, "a child has the wrong level");
            expect(child.right_wrong == edge.right_wrong, "edge", e, "only one of it and its child is right_wrong");
            expect(child.rest_length == 0.5F * edge.rest_length, "edge", e, "a child is not half as long");
            for (std::size_t s = 0; s < 2; ++s) {
                expect(bool(child.sides[s]) == bool(edge.sides[s]), "edge", e, "a hole opens along a child");
            }
        }
    }

    void check_triangle(TriangleId id) {
        const AdaptiveTriangle& t = mesh_.triangle(id);
        expect(!t.marked, "triangle", id, "retriangulate() was not called");
        unsigned split = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const AdaptiveEdge& edge = mesh_.edge(t.edges[k]);
            const std::size_t first = edge.ends[0] == t.vertices[k] ? 0 : 1;
            expect(edge.ends[first] == t.vertices[k] && edge.ends[1 - first] == t.vertices[(k + 1) % 3], "triangle", id,
                   "an edge does not join its vertices");
            const int s = mesh_.side_of(id, k);
            expect(edge.sides[static_cast<std::size_t>(s)] == id ||
                       (!t.regular && edge.level < t.level && mesh_.leaf_at(t.edges[k], s) == id),
                   "triangle", id, "it is not a side of its edge");
            split |= edge.centre ? 1U << k : 0U;
        }
        expect(t.regular || is_leaf(t), "triangle", id, "is irregular, yet refined");
        expect(layout(t.configuration).split == split, "triangle", id, "does not conform to its edges");
        if (!is_leaf(t)) check_internals(id, t);
    }

    void check_internals(TriangleId id, const AdaptiveTriangle& owner) {
        const Layout& inside = layout(owner.configuration);
        for (std::size_t i = 0; i < inside.edge_count; ++i) {
            const AdaptiveEdge& edge = mesh_.edge(owner.internal_edges[i]);
            expect(edge.level == owner.level + 1, "triangle", id, "an internal edge has the wrong level");
            expect(edge.sides[0] && edge.sides[1], "triangle", id, "a hole opens along an internal edge");
            expect(!edge.right_wrong, "triangle", id, "an internal edge is right_wrong");
            for (std::size_t k = 0; k < 2; ++k) {
                expect(edge.ends[k] == point(owner, inside.edges[i].points[k]), "triangle", id,
                       "an internal edge is not drawn as its configuration says");
            }
        }
        for (std::size_t i = 0; i < inside.triangle_count; ++i) {
            check_internal(id, owner, inside.triangles[i], mesh_.triangle(owner.internal_triangles[i]));
        }
    }

    void check_internal(TriangleId id, const AdaptiveTriangle& owner, const InternalTriangle& drawn,
                        const AdaptiveTriangle& inner) {
        expect(inner.level == owner.level + 1 && inner.panel == owner.panel && inner.turned == owner.turned, "triangle",
               id, "an internal triangle has the wrong level, panel or orientation");
        expect(inner.regular == (owner.configuration == Configuration::C10), "triangle", id,
               "an internal triangle is wrongly regular or irregular");
        for (std::size_t k = 0; k < 3; ++k) {
            expect(inner.vertices[k] == point(owner, drawn.points[k]), "triangle", id,
                   "an internal triangle is not drawn as its configuration says");
            expect(inner.u[k] == material(owner, drawn.points[k]), "triangle", id,
                   "an internal triangle has other material coordinates");
        }
    }

    VertexId point(const AdaptiveTriangle& owner, LocalPoint p) const {
        return p < 3 ? owner.vertices[p] : mesh_.edge(owner.edges[p - 3U]).centre;
    }

    static Vec2f material(const AdaptiveTriangle& owner, LocalPoint p) {
        if (p < 3) return owner.u[p];
        return 0.5F * (owner.u[p - 3U] + owner.u[(p - 2U) % 3]);
    }

    // No T-junction: the edges of a leaf triangle are leaves. No hole: a leaf edge has one leaf triangle for each side.
    void check_conformity() {
        std::vector<int> uses(mesh_.edges().capacity());
        for (const TriangleId t : reached_.leaf_triangles) {
            for (const EdgeId e : mesh_.triangle(t).edges) {
                expect(!mesh_.edge(e).centre, "triangle", t, "a T-junction lies on its edge");
                ++uses[e.value];
            }
        }
        for (const EdgeId e : reached_.leaf_edges) {
            const AdaptiveEdge& edge = mesh_.edge(e);
            expect(uses[e.value] == int(bool(edge.sides[0])) + int(bool(edge.sides[1])), "edge", e, "borders a hole");
            for (int s = 0; s < 2; ++s) check_leaf_at(e, s);
        }
    }

    void check_leaf_at(EdgeId e, int side) {
        const TriangleId leaf = mesh_.leaf_at(e, side);
        if (!leaf) return;
        const AdaptiveTriangle& t = mesh_.triangle(leaf);
        const std::size_t k = index_of(t, e);
        const int first = mesh_.edge(e).right_wrong ? 0 : side;
        expect(is_leaf(t) && t.edges[k] == e && t.vertices[k] == mesh_.end(e, first) && mesh_.side_of(leaf, k) == side,
               "edge", e, "finds the wrong leaf triangle");
    }

    // triangles_at() visits each leaf triangle of a vertex once.
    void check_adjacency() {
        std::vector<std::vector<TriangleId>> expected(mesh_.vertices().capacity());
        std::sort(reached_.leaf_triangles.begin(), reached_.leaf_triangles.end());
        for (const TriangleId t : reached_.leaf_triangles) {
            for (const VertexId v : mesh_.triangle(t).vertices) expected[v.value].push_back(t);
        }
        for (const VertexId v : reached_.leaf_vertices) {
            std::vector<TriangleId> listed;
            for (const TriangleId t : mesh_.triangles_at(v)) {
                listed.push_back(t);
                if (listed.size() > expected[v.value].size()) break;
            }
            std::sort(listed.begin(), listed.end());
            expect(listed == expected[v.value], "vertex", v, "its adjacent triangles are not those round it");
        }
    }

    void check_euler() {
        const auto base = static_cast<long>(mesh_.base_vertex_count()) - static_cast<long>(mesh_.base_edge_count()) +
                          static_cast<long>(mesh_.base_triangle_count());
        const auto leaves = static_cast<long>(reached_.leaf_vertices.size()) -
                            static_cast<long>(reached_.leaf_edges.size()) +
                            static_cast<long>(reached_.leaf_triangles.size());
        expect(base == leaves, "leaves: another Euler characteristic than the base mesh");
    }

    void check_area() {
        double base = 0.0, leaves = 0.0;
        for (std::uint32_t t = 0; t < mesh_.base_triangle_count(); ++t) {
            base += double(material_area(mesh_.triangle(TriangleId(t)).u));
        }
        for (const TriangleId t : reached_.leaf_triangles) leaves += double(material_area(mesh_.triangle(t).u));
        expect(std::abs(base - leaves) <= 1e-5 * base, "leaves: another material area than the base mesh");
    }

    template <class T, class Element, class GetId>
    void expect_same(std::string_view name, std::vector<T> expected, std::span<const Element> list, GetId&& id_of) {
        std::vector<T> listed;
        for (const Element& element : list) listed.push_back(id_of(element));
        std::sort(listed.begin(), listed.end());
        std::sort(expected.begin(), expected.end());
        expect(listed == expected, std::string(name) + ": the leaf list is not what a traversal finds");
    }

    void check_lists() {
        expect_same("vertices", reached_.leaf_vertices, mesh_.leaf_vertices(), [](VertexId v) { return v; });
        expect_same("edges", reached_.leaf_edges, mesh_.leaf_edges(), [](const LeafEdge& e) { return e.edge; });
        expect_same("triangles", reached_.leaf_triangles, mesh_.leaf_triangles(),
                    [](const LeafTriangle& t) { return t.triangle; });
        std::vector<EdgeId> inner;
        for (const EdgeId e : reached_.leaf_edges) {
            if (mesh_.edge(e).sides[0] && mesh_.edge(e).sides[1]) inner.push_back(e);
        }
        expect_same("hinges", inner, mesh_.hinges(), [](const Hinge& h) { return h.edge; });
        check_levels();
        check_leaf_contents();
        check_vertex_areas();
    }

    void check_levels() {
        for (int level = 0; level < mesh_.max_level(); ++level) {
            std::vector<EdgeId> unsplit, split;
            std::vector<TriangleId> refined;
            for_each_reached<EdgeId>(reached_.edges, [&](EdgeId e) {
                if (mesh_.level(e) == level) (mesh_.is_split(e) ? split : unsplit).push_back(e);
            });
            for_each_reached<TriangleId>(reached_.triangles, [&](TriangleId t) {
                if (mesh_.triangle(t).level == level && !is_leaf(mesh_.triangle(t))) refined.push_back(t);
            });
            const auto same = [](auto id) { return id; };
            expect_same("level's unsplit edges", unsplit, mesh_.unsplit_edges(level), same);
            expect_same("level's split edges", split, mesh_.split_edges(level), same);
            expect_same("level's refined triangles", refined, mesh_.refined_triangles(level), same);
        }
    }

    void check_leaf_contents() {
        for (const LeafEdge& e : mesh_.leaf_edges()) {
            expect(e.a == mesh_.end(e.edge, 0) && e.b == mesh_.end(e.edge, 1) &&
                       e.rest_length == mesh_.rest_length(e.edge),
                   "edge", e.edge, "its leaf is out of date");
        }
        for (const LeafTriangle& t : mesh_.leaf_triangles()) {
            const AdaptiveTriangle& own = mesh_.triangle(t.triangle);
            expect(t.v == own.vertices && t.u == own.u && t.turned == own.turned, "triangle", t.triangle,
                   "its leaf is out of date");
        }
        for (std::size_t i = 0; i < mesh_.hinges().size() && i < mesh_.leaf_edges().size(); ++i) {
            const Hinge& h = mesh_.hinges()[i];
            expect(h.edge == mesh_.leaf_edges()[i].edge, "edge", h.edge, "its hinge stands elsewhere than it does");
            if (reached_.edges[h.edge.value] > 0 && !mesh_.is_split(h.edge)) check_hinge(h);
        }
    }

    void check_hinge(const Hinge& h) {
        expect(h.a == mesh_.end(h.edge, 0) && h.b == mesh_.end(h.edge, 1) &&
                   h.rest_length == mesh_.rest_length(h.edge) && h.right_wrong == mesh_.edge(h.edge).right_wrong,
               "edge", h.edge, "its hinge is out of date");
        check_half_hinge(h, 0, h.left, h.left_at);
        check_half_hinge(h, 1, h.right, h.right_at);
    }

    void check_half_hinge(const Hinge& h, int side, VertexId opposite, const Vec2f& at) {
        const TriangleId leaf = mesh_.leaf_at(h.edge, side);
        if (!leaf) return expect(false, "edge", h.edge, "its hinge has no triangle at a side");
        const AdaptiveTriangle& t = mesh_.triangle(leaf);
        const std::size_t a = corner_at(t, h.a), b = corner_at(t, h.b), c = 3 - a - b;
        if (c > 2) return expect(false, "edge", h.edge, "its hinge is not at its triangle");
        const Vec2f along = (t.u[b] - t.u[a]).normalized(), arm = t.u[c] - 0.5F * (t.u[a] + t.u[b]);
        const float mirror = h.right_wrong && side == 1 ? -1.0F : 1.0F;
        const Vec2f expected(along.dot(arm), mirror * (along.x() * arm.y() - along.y() * arm.x()));
        const float tolerance = 1e-5F * (arm.norm() + t.u[c].norm());
        expect(opposite == t.vertices[c] && (at - expected).norm() <= tolerance &&
                   (h.along[static_cast<std::size_t>(side)] - along).norm() <= 1e-4F,
               "edge", h.edge, "a half of its hinge is out of date");
    }

    void check_vertex_areas() {
        std::vector<double> sums(mesh_.vertices().capacity());
        for (const TriangleId t : reached_.leaf_triangles) {
            const double third = double(material_area(mesh_.triangle(t).u)) / 3.0;
            for (const VertexId v : mesh_.triangle(t).vertices) sums[v.value] += third;
        }
        for (const VertexId v : reached_.leaf_vertices) {
            const bool is_known = v.value < mesh_.vertex_areas().size();
            expect(is_known && std::abs(double(mesh_.vertex_areas()[v.value]) - sums[v.value]) <= 1e-6 * sums[v.value],
                   "vertex", v, "its area is out of date");
        }
    }

    const AdaptiveMesh& mesh_;
    Reached reached_;
    std::vector<std::string> problems_;
};

}  // namespace

std::vector<std::string> check(const AdaptiveMesh& mesh) {
    return Checker(mesh).run();
}

}  // namespace selvedge::sim
