#include "tests/sim/adaptive/fixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace selvedge::sim::test {
namespace {

GarmentTriangle triangle_of(const std::array<int, 3>& v, const std::array<Vec2d, 3>& u, int panel = 0) {
    return {.vertices = v, .u = u, .panel = panel};
}

GarmentMesh flat_mesh(const std::vector<Vec2d>& points, const std::vector<std::array<int, 3>>& triangles) {
    GarmentMesh mesh;
    for (const Vec2d& p : points) mesh.x.emplace_back(p.x(), p.y(), 0.0);
    for (const auto& t : triangles) {
        const auto at = [&](int v) { return points[static_cast<std::size_t>(v)]; };
        mesh.triangles.push_back(triangle_of(t, {at(t[0]), at(t[1]), at(t[2])}));
    }
    mesh.panel_names = {"flat"};
    mesh.panel_grain_angles = {0.0};
    return mesh;
}

// Adds the two triangles of a quad with vertices v, anticlockwise, and material coordinates u.
void add_quad(GarmentMesh& mesh, const std::array<int, 4>& v, const std::array<Vec2d, 4>& u, int panel) {
    mesh.triangles.push_back(triangle_of({v[0], v[1], v[2]}, {u[0], u[1], u[2]}, panel));
    mesh.triangles.push_back(triangle_of({v[0], v[2], v[3]}, {u[0], u[2], u[3]}, panel));
}

// The elements of a pool; free elements are value-initialised, so that they compare equal.
template <class T, class ElementId>
std::vector<T> contents(const Pool<T, ElementId>& pool) {
    std::vector<T> all;
    for (std::uint32_t i = 0; i < pool.capacity(); ++i) all.push_back(pool[ElementId(i)]);
    for (const ElementId id : pool.free_ids()) all[id.value] = T{};
    return all;
}

LeafLists sorted(LeafLists leaves) {
    const auto sort_by = [](auto& list, auto&& id_of) {
        std::sort(list.begin(), list.end(), [&](const auto& a, const auto& b) { return id_of(a) < id_of(b); });
    };
    sort_by(leaves.vertices, [](VertexId v) { return v; });
    sort_by(leaves.edges, [](const LeafEdge& e) { return e.edge; });
    sort_by(leaves.triangles, [](const LeafTriangle& t) { return t.triangle; });
    sort_by(leaves.hinges, [](const Hinge& h) { return h.edge; });
    return leaves;
}

}  // namespace

GarmentMesh one_triangle() {
    return flat_mesh({{0.0, 0.0}, {1.0, 0.0}, {0.25, 0.75}}, {{0, 1, 2}});
}

GarmentMesh two_triangles() {
    return flat_mesh({{0.0, 0.0}, {1.0, 0.0}, {0.25, 0.75}, {1.5, 1.0}}, {{0, 1, 2}, {1, 3, 2}});
}

GarmentMesh bow_tie() {
    return flat_mesh({{0.0, 0.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}}, {{0, 1, 2}, {0, 3, 4}});
}

GarmentMesh octahedron() {
    GarmentMesh mesh;
    mesh.x = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const double side = std::sqrt(2.0);
    const std::array<Vec2d, 3> u{Vec2d(0.0, 0.0), Vec2d(side, 0.0), Vec2d(side / 2, side * std::sqrt(0.75))};
    for (int i = 0; i < 4; ++i) {
        mesh.triangles.push_back(triangle_of({i, (i + 1) % 4, 4}, u, i));
        mesh.triangles.push_back(triangle_of({(i + 1) % 4, i, 5}, u, i));
    }
    return mesh;
}

GarmentMesh tube(int columns, int rows) {
    GarmentMesh mesh;
    const double radius = 0.1 * columns / (2.0 * std::numbers::pi);
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double angle = 2.0 * std::numbers::pi * column / columns;
            mesh.x.emplace_back(radius * std::sin(angle), 0.1 * row, radius * std::cos(angle));
        }
    }
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const int a = row * columns + column, b = row * columns + (column + 1) % columns;
            const double left = 0.1 * column, right = 0.1 * (column + 1), low = 0.1 * row, high = 0.1 * (row + 1);
            add_quad(mesh, {a, b, b + columns, a + columns},
                     {Vec2d(left, low), Vec2d(right, low), Vec2d(right, high), Vec2d(left, high)}, 0);
        }
    }
    return mesh;
}

GarmentMesh front_and_back(int rows, double back_ratio) {
    GarmentMesh mesh;
    for (int row = 0; row <= rows; ++row) {
        mesh.x.emplace_back(-0.1, 0.2 * row, 0.0);
        mesh.x.emplace_back(0.0, 0.2 * row, 0.1);
        mesh.x.emplace_back(0.1, 0.2 * row, 0.0);
        mesh.x.emplace_back(0.0, 0.2 * row, -0.1);
    }
    // In material coordinates the front starts at u = 0 m, the back at u = 7 m.
    const std::array<double, 4> starts = {0.0, 0.1, 7.0, 7.15}, widths = {0.1, 0.1, 0.15, 0.15};
    for (int row = 0; row < rows; ++row) {
        for (std::size_t i = 0; i < 4; ++i) {
            const int panel = i < 2 ? 0 : 1, a = 4 * row + static_cast<int>(i),
                      b = 4 * row + (static_cast<int>(i) + 1) % 4;
            const double scale = panel == 0 ? 1.0 : back_ratio, base = panel == 0 ? 0.0 : 5.0;
            const double left = starts[i], right = left + widths[i];
            const double low = base + 0.2 * row * scale, high = base + 0.2 * (row + 1) * scale;
            add_quad(mesh, {a, b, b + 4, a + 4},
                     {Vec2d(left, low), Vec2d(right, low), Vec2d(right, high), Vec2d(left, high)}, panel);
        }
    }
    return mesh;
}

EdgeId edge_between(const AdaptiveMesh& mesh, VertexId a, VertexId b) {
    const auto joins = [&](EdgeId e) {
        const std::array<VertexId, 2>& ends = mesh.edge(e).ends;
        return ends == std::array{a, b} || ends == std::array{b, a};
    };
    for (const LeafEdge& e : mesh.leaf_edges()) {
        if (joins(e.edge)) return e.edge;
    }
    for (int level = 0; level < mesh.max_level(); ++level) {
        for (const EdgeId e : mesh.split_edges(level)) {
            if (joins(e)) return e;
        }
    }
    ADD_FAILURE() << "no edge between " << a.value << " and " << b.value;
    return {};
}

PositionState::PositionState(const GarmentMesh& base, const AdaptiveMesh& mesh) {
    on_capacity(mesh.vertex_capacity());
    for (std::size_t i = 0; i < base.x.size(); ++i) {
        x[i] = base.x[i].cast<float>();
        is_used[i] = true;
    }
}

void PositionState::on_capacity(std::size_t n) {
    x.resize(n, Vec3f::Zero());
    is_used.resize(n, false);
}

void PositionState::on_split(VertexId centre, VertexId a, VertexId b) {
    EXPECT_LT(centre.value, x.size());
    EXPECT_FALSE(is_used[centre.value]);
    EXPECT_TRUE(is_used[a.value] && is_used[b.value]);
    is_used[centre.value] = true;
    x[centre.value] = 0.5F * (x[a.value] + x[b.value]);
}

void PositionState::on_rejoin(VertexId centre) {
    EXPECT_TRUE(is_used[centre.value]);
    is_used[centre.value] = false;
    x[centre.value].setZero();
}

Snapshot::Snapshot(const AdaptiveMesh& mesh)
    : vertices(contents(mesh.vertices())),
      edges(contents(mesh.edges())),
      triangles(contents(mesh.triangles())),
      leaves(sorted(mesh.leaves())) {}

Snapshot Snapshot::cut_to(const AdaptiveMesh& base) const {
    Snapshot part = *this;
    part.vertices.resize(base.base_vertex_count());
    part.edges.resize(base.base_edge_count());
    part.triangles.resize(base.base_triangle_count());
    part.leaves.vertex_areas.resize(base.base_vertex_count());
    return part;
}

}  // namespace selvedge::sim::test
