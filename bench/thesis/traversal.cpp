// Table 3.6: reaching all leaves by recursion through the hierarchy, and through flat lists.
#include "bench/thesis/thesis.h"
#include "bench/timing.h"
#include "sim/adaptive/square.h"
#include "sim/adaptive/uniform.h"

namespace selvedge {
namespace {

// What is done at each leaf is the same both ways, and little: a sum over what it knows.
struct Sums {
    double edges = 0;      // of rest lengths, m
    double triangles = 0;  // of material areas, m^2
    long edge_count = 0;
    long triangle_count = 0;

    void add_edge(float rest_length) {
        edges += static_cast<double>(rest_length);
        ++edge_count;
    }
    void add_triangle(const std::array<Vec2f, 3>& u) {
        triangles += static_cast<double>(material_area(u));
        ++triangle_count;
    }
};

void visit_edge(const AdaptiveMesh& mesh, EdgeId id, Sums& sums) {
    const AdaptiveEdge& edge = mesh.edge(id);
    if (!edge.centre) return sums.add_edge(edge.rest_length);
    for (const EdgeId child : edge.children) visit_edge(mesh, child, sums);
}

void visit_triangle_edges(const AdaptiveMesh& mesh, TriangleId id, Sums& sums) {
    const AdaptiveTriangle& t = mesh.triangle(id);
    if (is_leaf(t)) return;
    const Layout& inside = layout(t.configuration);
    for (std::size_t i = 0; i < inside.edge_count; ++i) visit_edge(mesh, t.internal_edges[i], sums);
    for (std::size_t i = 0; i < inside.triangle_count; ++i) visit_triangle_edges(mesh, t.internal_triangles[i], sums);
}

void visit_triangle(const AdaptiveMesh& mesh, TriangleId id, Sums& sums) {
    const AdaptiveTriangle& t = mesh.triangle(id);
    if (is_leaf(t)) return sums.add_triangle(t.u);
    for (std::size_t i = 0; i < layout(t.configuration).triangle_count; ++i)
        visit_triangle(mesh, t.internal_triangles[i], sums);
}

Sums edges_by_recursion(const AdaptiveMesh& mesh) {
    Sums sums;
    for (std::uint32_t e = 0; e < mesh.base_edge_count(); ++e) visit_edge(mesh, EdgeId(e), sums);
    for (std::uint32_t t = 0; t < mesh.base_triangle_count(); ++t) visit_triangle_edges(mesh, TriangleId(t), sums);
    return sums;
}

Sums triangles_by_recursion(const AdaptiveMesh& mesh) {
    Sums sums;
    for (std::uint32_t t = 0; t < mesh.base_triangle_count(); ++t) visit_triangle(mesh, TriangleId(t), sums);
    return sums;
}

Sums edges_by_list(const AdaptiveMesh& mesh) {
    Sums sums;
    for (const LeafEdge& edge : mesh.leaf_edges()) sums.add_edge(edge.rest_length);
    return sums;
}

Sums triangles_by_list(const AdaptiveMesh& mesh) {
    Sums sums;
    for (const LeafTriangle& t : mesh.leaf_triangles()) sums.add_triangle(t.u);
    return sums;
}

// us, recursion and list in turns.
template <class Recursion, class List>
std::array<double, 2> compare(const AdaptiveMesh& mesh, int runs, Recursion&& recursion, List&& list) {
    std::vector<double> by_recursion, by_list;
    for (int i = 0; i < runs; ++i) {
        by_recursion.push_back(time_once([&] { keep(recursion(mesh)); }));
        by_list.push_back(time_once([&] { keep(list(mesh)); }));
    }
    return {1e6 * timing_of(by_recursion).median, 1e6 * timing_of(by_list).median};
}

}  // namespace

ThesisResult measure_traversal(const ThesisOptions& options) {
    AdaptiveMesh mesh(make_square({.columns = 8, .rows = 8}));
    NoState none;
    Table table{.name = "3.6",
                .title = "Reaching all leaves: recursion through the hierarchy against flat lists",
                .note =
                    "Base mesh of 128 triangles, the same level everywhere. At each leaf a rest length or an area "
                    "is summed. us, median of runs.",
                .columns = {"level", "leaf edges", "edges by recursion, us", "edges by list, us", "ratio",
                            "leaf triangles", "triangles by recursion, us", "triangles by list, us", "ratio "}};
    const int runs = options.is_quick ? 1 : 101;
    for (int level = 0; level <= mesh.max_level(); ++level) {
        set_uniform_level(mesh, none, level);
        const auto edges = compare(mesh, runs, edges_by_recursion, edges_by_list);
        const auto triangles = compare(mesh, runs, triangles_by_recursion, triangles_by_list);
        SELVEDGE_ASSERT(edges_by_recursion(mesh).edge_count == edges_by_list(mesh).edge_count);
        table.add_row({level, edges_by_recursion(mesh).edge_count, Cell(edges[0], 2), Cell(edges[1], 2),
                       Cell(edges[0] / edges[1], 1), triangles_by_recursion(mesh).triangle_count, Cell(triangles[0], 2),
                       Cell(triangles[1], 2), Cell(triangles[0] / triangles[1], 1)});
    }
    ThesisResult result;
    result.tables = {table};
    return result;
}

}  // namespace selvedge
