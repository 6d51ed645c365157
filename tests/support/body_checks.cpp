#include "tests/support/body_checks.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <algorithm>
#include <utility>
#include <vector>

namespace selvedge::sim {
namespace {

std::vector<std::pair<int, int>> directed_edges(const Body& body) {
    std::vector<std::pair<int, int>> edges;
    for (const auto& [a, b, c] : body.triangles) {
        edges.emplace_back(a, b);
        edges.emplace_back(b, c);
        edges.emplace_back(c, a);
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

int count_pieces(const Body& body) {
    std::vector<int> parent(body.x.size());
    for (std::size_t v = 0; v < parent.size(); ++v) parent[v] = static_cast<int>(v);
    const auto root = [&](int v) {
        while (parent[static_cast<std::size_t>(v)] != v) {
            int& up = parent[static_cast<std::size_t>(v)];
            v = up = parent[static_cast<std::size_t>(up)];
        }
        return v;
    };
    auto pieces = static_cast<int>(body.x.size());
    for (const auto& [a, b] : directed_edges(body)) {
        const int from = root(a);
        const int to = root(b);
        if (from == to) continue;
        parent[static_cast<std::size_t>(from)] = to;
        --pieces;
    }
    return pieces;
}

}  // namespace

bool is_closed_manifold(const Body& body) {
    const auto edges = directed_edges(body);
    if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) return false;
    const bool is_closed = std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
        return std::binary_search(edges.begin(), edges.end(), std::pair(edge.second, edge.first));
    });
    const auto vertices = static_cast<std::ptrdiff_t>(body.x.size());
    const auto triangles = static_cast<std::ptrdiff_t>(body.triangles.size());
    return is_closed && count_pieces(body) == 1 && vertices - 3 * triangles / 2 + triangles == 2;
}

double volume(const Body& body) {
    double six = 0;
    for (const auto& [a, b, c] : body.triangles) {
        const Vec3d& x = body.x[static_cast<std::size_t>(a)];
        six += x.dot(body.x[static_cast<std::size_t>(b)].cross(body.x[static_cast<std::size_t>(c)]));
    }
    return six / 6;
}

int count_self_intersections(const Body& body) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
    Mesh mesh;
    for (const Vec3d& x : body.x) mesh.add_vertex(Kernel::Point_3(x.x(), x.y(), x.z()));
    for (const auto& triangle : body.triangles) {
        mesh.add_face(Mesh::Vertex_index(static_cast<unsigned>(triangle[0])),
                      Mesh::Vertex_index(static_cast<unsigned>(triangle[1])),
                      Mesh::Vertex_index(static_cast<unsigned>(triangle[2])));
    }
    std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
    CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
    return static_cast<int>(pairs.size());
}

}  // namespace selvedge::sim
