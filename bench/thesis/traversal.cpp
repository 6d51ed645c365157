#include "bench/thesis/traversal.h"

#include <array>
#include <cmath>

#include "bench/support/cloth_run.h"
#include "bench/support/measured_mesh.h"
#include "bench/thesis/thesis.h"
#include "sim/adaptive/criteria.h"
#include "sim/core/gravity.h"
#include "sim/mesh/square.h"

namespace selvedge::bench {
namespace {

constexpr float kSeconds = 0.001F;       // s, of a step
constexpr float kSpring = 2.0F;          // N/m; weak, as in the thesis: the corrections keep the length
constexpr float kBend = 1e-4F;           // N
constexpr float kDensity = 0.12F;        // kg/m^2
constexpr float kKept = 0.999F;          // share of the velocity that is kept per step
constexpr float kCorrectedFrom = 1.01F;  // times the rest length, from which an edge is corrected
const Vec3f kAcceleration = sim::standard_gravity();

// The work at each element, the same for every traversal.

void clear_force(SpringState& state, std::uint32_t v) {
    state.force[v].setZero();
}

void add_spring(SpringState& state, std::uint32_t a, std::uint32_t b, float rest_length) {
    const Vec3f d = state.x[b] - state.x[a];
    const float length = d.norm();
    const Vec3f pull = (kSpring * (length - rest_length) / length) * d;
    state.force[a] += pull;
    state.force[b] -= pull;
}

// Forces along the normals of both triangles, which sum to zero.  (thesis 3.6.3)
void add_bending(SpringState& state, const std::array<std::uint32_t, 4>& v) {
    const auto& [a, b, left, right] = v;
    const Vec3f& xa = state.x[a];
    const Vec3f along = state.x[b] - xa;
    const Vec3f n_left = along.cross(state.x[left] - xa).normalized();
    const Vec3f n_right = (state.x[right] - xa).cross(along).normalized();
    const float sine = n_left.cross(n_right).dot(along.normalized());
    const Vec3f on_left = (kBend * sine) * n_left, on_right = (kBend * sine) * n_right;
    state.force[left] += on_left;
    state.force[right] += on_right;
    const Vec3f half = 0.5F * (on_left + on_right);
    state.force[a] -= half;
    state.force[b] -= half;
}

void move(SpringState& state, std::uint32_t v) {
    if (state.inverse_mass[v] == 0) return;
    const Vec3f x = state.x[v];
    const Vec3f acceleration = state.inverse_mass[v] * state.force[v] + kAcceleration;
    state.x[v] = x + kKept * (x - state.x_prev[v]) + (kSeconds * kSeconds) * acceleration;
    state.x_prev[v] = x;
}

// After Provot (1995), for unequal masses.  (thesis listing 3.12)
void correct_length(SpringState& state, std::uint32_t a, std::uint32_t b, float rest_length) {
    const Vec3f d = state.x[b] - state.x[a];
    const float length = d.norm(), w = state.inverse_mass[a] + state.inverse_mass[b];
    if (length <= kCorrectedFrom * rest_length || w == 0) return;
    const Vec3f c = ((length - kCorrectedFrom * rest_length) / (length * w)) * d;
    state.x[a] += state.inverse_mass[a] * c;
    state.x[b] -= state.inverse_mass[b] * c;
}

// The corner of a leaf triangle that is not on the edge.
std::uint32_t opposite(const sim::AdaptiveMesh& mesh, sim::TriangleId id, const sim::AdaptiveEdge& edge) {
    for (const sim::VertexId v : mesh.triangle(id).vertices) {
        if (v != edge.ends[0] && v != edge.ends[1]) return v.value;
    }
    return edge.ends[0].value;
}

void add_edge_forces(const sim::AdaptiveMesh& mesh, SpringState& state, sim::EdgeId e) {
    const sim::AdaptiveEdge& edge = mesh.edge(e);
    const std::uint32_t a = edge.ends[0].value, b = edge.ends[1].value;
    add_spring(state, a, b, edge.rest_length);
    const sim::TriangleId left = mesh.leaf_at(e, 0), right = mesh.leaf_at(e, 1);
    if (left && right) add_bending(state, {a, b, opposite(mesh, left, edge), opposite(mesh, right, edge)});
}

// Leaf edges and vertices by recursion: down from the base edges, and from the edges inside each refined triangle.

template <class F>
void visit_edge(const sim::AdaptiveMesh& mesh, sim::EdgeId id, F&& f) {
    const sim::AdaptiveEdge& edge = mesh.edge(id);
    if (!edge.centre) return f(id);
    for (const sim::EdgeId child : edge.children) visit_edge(mesh, child, f);
}

template <class F>
void visit_inside(const sim::AdaptiveMesh& mesh, sim::TriangleId id, F&& f) {
    const sim::AdaptiveTriangle& t = mesh.triangle(id);
    if (is_leaf(t)) return;
    const sim::Layout& inside = layout(t.configuration);
    for (std::size_t i = 0; i < inside.edge_count; ++i) f(t.internal_edges[i]);
    for (std::size_t i = 0; i < inside.triangle_count; ++i) visit_inside(mesh, t.internal_triangles[i], f);
}

template <class F>
void visit_roots(const sim::AdaptiveMesh& mesh, F&& f) {
    for (std::uint32_t e = 0; e < mesh.base_edge_count(); ++e) f(sim::EdgeId(e));
    for (std::uint32_t t = 0; t < mesh.base_triangle_count(); ++t) visit_inside(mesh, sim::TriangleId(t), f);
}

template <class F>
void visit_edges(const sim::AdaptiveMesh& mesh, F&& f) {
    visit_roots(mesh, [&](sim::EdgeId root) { visit_edge(mesh, root, f); });
}

template <class F>
void visit_centres(const sim::AdaptiveMesh& mesh, sim::EdgeId id, F&& f) {
    const sim::AdaptiveEdge& edge = mesh.edge(id);
    if (!edge.centre) return;
    f(edge.centre);
    for (const sim::EdgeId child : edge.children) visit_centres(mesh, child, f);
}

template <class F>
void visit_vertices(const sim::AdaptiveMesh& mesh, F&& f) {
    for (std::uint32_t v = 0; v < mesh.base_vertex_count(); ++v) f(sim::VertexId(v));
    visit_roots(mesh, [&](sim::EdgeId root) { visit_centres(mesh, root, f); });
}

}  // namespace

SpringState make_spring_state(const sim::AdaptiveMesh& mesh, const std::vector<Vec3d>& x) {
    const std::size_t capacity = mesh.vertex_capacity();
    SpringState state;
    state.x.assign(capacity, Vec3f::Zero());
    state.force.assign(capacity, Vec3f::Zero());
    state.inverse_mass.assign(capacity, 0.0F);
    for (std::size_t v = 0; v < x.size(); ++v) state.x[v] = x[v].cast<float>();
    visit_roots(mesh, [&](sim::EdgeId root) {
        const auto place = [&](const auto& self, sim::EdgeId e) -> void {
            const sim::AdaptiveEdge& edge = mesh.edge(e);
            if (!edge.centre) return;
            state.x[edge.centre.value] = 0.5F * (state.x[edge.ends[0].value] + state.x[edge.ends[1].value]);
            for (const sim::EdgeId child : edge.children) self(self, child);
        };
        place(place, root);
    });
    state.x_prev = state.x;
    for (const sim::VertexId v : mesh.leaf_vertices())
        state.inverse_mass[v.value] = v.value < 2 ? 0 : 1 / (kDensity * mesh.vertex_areas()[v.value]);
    return state;
}

void collect_leaves(const sim::AdaptiveMesh& mesh, TemporaryLists& lists) {
    lists.vertices.clear();
    lists.edges.clear();
    visit_vertices(mesh, [&](sim::VertexId v) { lists.vertices.push_back(v); });
    visit_edges(mesh, [&](sim::EdgeId e) { lists.edges.push_back(e); });
}

void step_by_recursion(const sim::AdaptiveMesh& mesh, SpringState& state) {
    visit_vertices(mesh, [&](sim::VertexId v) { clear_force(state, v.value); });
    visit_edges(mesh, [&](sim::EdgeId e) { add_edge_forces(mesh, state, e); });
    visit_vertices(mesh, [&](sim::VertexId v) { move(state, v.value); });
    visit_edges(mesh, [&](sim::EdgeId e) {
        const sim::AdaptiveEdge& edge = mesh.edge(e);
        correct_length(state, edge.ends[0].value, edge.ends[1].value, edge.rest_length);
    });
}

void step_by_lists(const sim::AdaptiveMesh& mesh, const TemporaryLists& lists, SpringState& state) {
    for (const sim::VertexId v : lists.vertices) clear_force(state, v.value);
    for (const sim::EdgeId e : lists.edges) add_edge_forces(mesh, state, e);
    for (const sim::VertexId v : lists.vertices) move(state, v.value);
    for (const sim::EdgeId e : lists.edges) {
        const sim::AdaptiveEdge& edge = mesh.edge(e);
        correct_length(state, edge.ends[0].value, edge.ends[1].value, edge.rest_length);
    }
}

void step_by_flat_lists(const sim::AdaptiveMesh& mesh, SpringState& state) {
    for (const sim::VertexId v : mesh.leaf_vertices()) clear_force(state, v.value);
    for (const sim::LeafEdge& e : mesh.leaf_edges()) add_spring(state, e.a.value, e.b.value, e.rest_length);
    for (const sim::Hinge& h : mesh.hinges()) add_bending(state, {h.a.value, h.b.value, h.left.value, h.right.value});
    for (const sim::VertexId v : mesh.leaf_vertices()) move(state, v.value);
    for (const sim::LeafEdge& e : mesh.leaf_edges()) correct_length(state, e.a.value, e.b.value, e.rest_length);
}

// Table 3.6.

namespace {

// ms, medians.
struct TraversalTimes {
    double recursion = 0, lists = 0, flat = 0, creating = 0;
};

TraversalTimes measure_steps(const sim::AdaptiveMesh& mesh, const SpringState& start, int runs) {
    SpringState state = start;
    TemporaryLists lists;
    std::vector<double> recursion, by_lists, flat, creating;
    for (int i = 0; i < runs; ++i) {
        recursion.push_back(time_once([&] { step_by_recursion(mesh, state); }));
        creating.push_back(time_once([&] { collect_leaves(mesh, lists); }));
        by_lists.push_back(time_once([&] { step_by_lists(mesh, lists, state); }));
        flat.push_back(time_once([&] { step_by_flat_lists(mesh, state); }));
    }
    const auto ms = [](const std::vector<double>& seconds) { return 1e3 * timing_of(seconds).median; };
    return {.recursion = ms(recursion), .lists = ms(by_lists), .flat = ms(flat), .creating = ms(creating)};
}

}  // namespace

ThesisResult measure_traversal(const ThesisOptions& options) {
    const sim::GarmentMesh base = sim::make_square({.columns = 8, .rows = 8});
    sim::AdaptiveMesh mesh(base);
    sim::NoState none;
    Table table{
        .name = "3.6",
        .title = "A simulation step by recursion and by temporary lists of the leaves",
        .note =
            "Base mesh of 128 triangles, the same level everywhere. The step is the thesis' own kind: springs, "
            "bending, Verlet and one correction of all edge lengths; it visits all vertices twice and all "
            "edges twice. Temporary lists hold ids and are created once per adaptation, here by recursion; "
            "Selvedge's flat lists also hold the data and are updated where the mesh changes. CPU time of one "
            "thread, median of runs.",
        .columns = {"level", "leaf triangles", "leaf edges", "step by recursion, ms", "step by temporary lists, ms",
                    "creating the lists, ms", "four steps and one creation by lists / four by recursion",
                    "step by Selvedge's flat lists, ms"}};
    Trend trend{.item = "T3.6",
                .reported = "lists, created once per adaptive step, take the place of recursion.",
                .measured = {},
                .agrees = true};
    const int runs = options.is_quick ? 1 : 201;
    for (int level = 0; level <= mesh.max_level(); ++level) {
        set_uniform_level(mesh, none, level);
        const TraversalTimes ms = measure_steps(mesh, make_spring_state(mesh, base.x), runs);
        const double share = (4 * ms.lists + ms.creating) / (4 * ms.recursion);
        table.add_row({level, mesh.leaf_triangles().size(), mesh.leaf_edges().size(), Cell(ms.recursion, 4),
                       Cell(ms.lists, 4), Cell(ms.creating, 4), Cell(share, 2), Cell(ms.flat, 4)});
        if (level == mesh.max_level()) {
            trend.agrees = share < 1;
            trend.measured = "at level 3, four steps and one creation by lists take " + Cell(share, 2).to_text() +
                             " of the time of four steps by recursion.";
        }
    }
    return {.tables = {table}, .trends = {trend}};
}

}  // namespace selvedge::bench
