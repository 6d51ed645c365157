#include "sim/adaptive/leaf_lists.h"

#include <cmath>

#include "sim/adaptive/adaptive_mesh.h"

namespace selvedge {
namespace {

// A triangle beside an edge, as seen from the edge: the origin is its middle, x runs from a to b.
struct Unfolded {
    VertexId opposite;
    Vec2f at;
    Vec2f along;
};

float cross(const Vec2f& a, const Vec2f& b) {
    return a.x() * b.y() - a.y() * b.x();
}

// Pre: a and b are corners of the triangle.
Unfolded unfold(const AdaptiveTriangle& triangle, VertexId a, VertexId b) {
    const std::size_t at_a = corner_at(triangle, a), at_b = corner_at(triangle, b), at_c = 3 - at_a - at_b;
    const Vec2f along = (triangle.u[at_b] - triangle.u[at_a]).normalized();
    const Vec2f arm = triangle.u[at_c] - 0.5F * (triangle.u[at_a] + triangle.u[at_b]);
    return {triangle.vertices[at_c], {along.dot(arm), cross(along, arm)}, along};
}

void gather_vertices(const AdaptiveMesh& mesh, std::vector<VertexId>& vertices) {
    vertices.clear();
    for (std::uint32_t v = 0; v < mesh.base_vertex_count(); ++v) vertices.emplace_back(v);
    for (int level = 0; level <= mesh.max_level(); ++level) {
        for (const EdgeId e : mesh.split_edges(level)) vertices.push_back(mesh.centre(e));
    }
}

void gather_edges(const AdaptiveMesh& mesh, std::vector<LeafEdge>& edges) {
    edges.clear();
    for (int level = 0; level <= mesh.max_level(); ++level) {
        for (const EdgeId e : mesh.unsplit_edges(level)) {
            const AdaptiveEdge& edge = mesh.edge(e);
            edges.push_back({edge.ends[0], edge.ends[1], edge.rest_length, e});
        }
    }
}

void gather_triangles(const AdaptiveMesh& mesh, std::vector<LeafTriangle>& triangles) {
    triangles.clear();
    for (int level = 0; level <= mesh.max_level(); ++level) {
        for (const TriangleId id : mesh.leaf_triangles(level)) {
            const AdaptiveTriangle& t = mesh.triangle(id);
            triangles.push_back({t.vertices, t.u, id, t.panel, t.level});
        }
    }
}

void gather_hinges(const AdaptiveMesh& mesh, const std::vector<LeafEdge>& edges, std::vector<Hinge>& hinges) {
    hinges.clear();
    for (const LeafEdge& edge : edges) {
        const TriangleId left_id = mesh.leaf_at(edge.edge, 0), right_id = mesh.leaf_at(edge.edge, 1);
        if (!left_id || !right_id) continue;
        const Unfolded left = unfold(mesh.triangle(left_id), edge.a, edge.b);
        const Unfolded right = unfold(mesh.triangle(right_id), edge.a, edge.b);
        hinges.push_back({edge.a,
                          edge.b,
                          left.opposite,
                          right.opposite,
                          edge.rest_length,
                          left.at,
                          right.at,
                          {left.along, right.along},
                          edge.edge});
    }
}

void gather_vertex_areas(const std::vector<LeafTriangle>& triangles, std::size_t capacity, std::vector<float>& areas) {
    areas.assign(capacity, 0.0F);
    for (const LeafTriangle& triangle : triangles) {
        const float third = material_area(triangle.u) / 3.0F;
        for (const VertexId v : triangle.v) areas[v.value] += third;
    }
}

}  // namespace

float material_area(const std::array<Vec2f, 3>& u) {
    return 0.5F * cross(u[1] - u[0], u[2] - u[0]);
}

void gather_leaves(const AdaptiveMesh& mesh, LeafLists& lists) {
    gather_vertices(mesh, lists.vertices);
    gather_edges(mesh, lists.edges);
    gather_triangles(mesh, lists.triangles);
    gather_hinges(mesh, lists.edges, lists.hinges);
    gather_vertex_areas(lists.triangles, mesh.vertex_capacity(), lists.vertex_areas);
}

}  // namespace selvedge
