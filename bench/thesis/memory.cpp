// Table 3.11: what elements take, and whole hierarchies.
#include "bench/thesis/thesis.h"
#include "sim/adaptive/square.h"
#include "sim/adaptive/uniform.h"
#include "sim/cloth/cloth.h"

namespace selvedge {
namespace {

constexpr AdaptiveMesh::BytesPerElement kBytes = AdaptiveMesh::bytes_per_element();
constexpr std::size_t kThesisVertex = 144, kThesisEdge = 52, kThesisTriangle = 120;

// What stands in the cloth's state arrays for one vertex.
constexpr std::size_t kClothBytes = 2 * sizeof(Vec4f) + sizeof(float) + sizeof(Vec3f);

template <class T>
std::size_t bytes_of(const std::vector<T>& list) {
    return list.size() * sizeof(T);
}

std::size_t list_bytes(const LeafLists& leaves) {
    return bytes_of(leaves.vertices) + bytes_of(leaves.edges) + bytes_of(leaves.triangles) + bytes_of(leaves.hinges) +
           bytes_of(leaves.vertex_areas);
}

void add_elements(Table& table) {
    table.add_row({"one element", Cell(), kBytes.vertex, kBytes.edge, kBytes.triangle, Cell(), Cell(), Cell(), Cell()});
    table.add_row({"one element, the thesis", Cell(), kThesisVertex, kThesisEdge, kThesisTriangle, Cell(), Cell(),
                   Cell(), Cell()});
}

void add_hierarchy(Table& table, AdaptiveMesh& mesh, int level) {
    NoState none;
    set_uniform_level(mesh, none, level);
    const std::size_t vertices = mesh.vertices().size(), edges = mesh.edges().size(),
                      triangles = mesh.triangles().size();
    const std::size_t ours = vertices * kBytes.vertex + edges * kBytes.edge + triangles * kBytes.triangle;
    const std::size_t thesis = vertices * kThesisVertex + edges * kThesisEdge + triangles * kThesisTriangle;
    table.add_row({std::to_string(mesh.base_triangle_count()) + " triangles", level, vertices * kBytes.vertex,
                   edges * kBytes.edge, triangles * kBytes.triangle, ours, thesis, list_bytes(mesh.leaves()),
                   vertices * kClothBytes});
}

}  // namespace

ThesisResult measure_memory(const ThesisOptions& options) {
    Table table{.name = "3.11",
                .title = "Memory, bytes",
                .note =
                    "Elements alive, adjacency, corner coordinates and their places in the pools' free lists "
                    "counted (64-bit build). The thesis' figures (32-bit pointers) are for the same elements. "
                    "Leaf lists and the cloth's positions, velocities, masses and normals come on top.",
                .columns = {"mesh", "level", "vertices", "edges", "triangles", "together", "the thesis' elements",
                            "leaf lists", "cloth's state"}};
    add_elements(table);
    for (const int quads : options.is_quick ? std::vector<int>{4} : std::vector<int>{4, 8, 16, 32}) {
        AdaptiveMesh mesh(make_square({.columns = quads, .rows = quads}));
        for (int level = 0; level <= mesh.max_level(); ++level) add_hierarchy(table, mesh, level);
    }
    ThesisResult result;
    result.tables = {table};
    return result;
}

}  // namespace selvedge
