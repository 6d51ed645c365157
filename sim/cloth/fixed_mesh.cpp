#include "sim/cloth/fixed_mesh.h"

#include <algorithm>

#include "sim/core/assert.h"

namespace selvedge::sim {
namespace {

using Weights = std::array<int, 3>;  // barycentric coordinates times any positive number

// The local points of configuration.h in barycentric coordinates times two.
constexpr std::array<Weights, 6> kLocalPoints{{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}}};

constexpr int determinant(const Weights& a, const Weights& b, const Weights& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// The coordinates in an internal triangle of a point of its owner (Cramer's rule). Their sum is that of `at` in a
// quarter of the owner, twice that in a half.
Weights weights_in(const InternalTriangle& inner, const Weights& at) {
    const Weights& a = kLocalPoints[inner.points[0]];
    const Weights& b = kLocalPoints[inner.points[1]];
    const Weights& c = kLocalPoints[inner.points[2]];
    return {determinant(at, b, c), determinant(a, at, c), determinant(a, b, at)};
}

bool is_corner(const Weights& at) {
    return int{at[0] == 0} + int{at[1] == 0} + int{at[2] == 0} == 2;
}

// Sums with zero terms have the same bits in any order, so a point on a common edge of two triangles has the same
// position in both.
Vec3f position(const Cloth& cloth, const AdaptiveTriangle& t, const Weights& at) {
    if (is_corner(at)) return cloth.x[t.vertices[at[0] > 0 ? 0 : (at[1] > 0 ? 1 : 2)].value].head<3>();
    const auto sum = static_cast<float>(at[0] + at[1] + at[2]);
    Vec3f x = Vec3f::Zero();
    for (std::size_t k = 0; k < 3; ++k)
        if (at[k] > 0) x += static_cast<float>(at[k]) / sum * cloth.x[t.vertices[k].value].head<3>();
    return x;
}

Vec3f position(const Cloth& cloth, const FixedSample& sample) {
    const AdaptiveTriangle* t = &cloth.mesh.triangle(sample.triangle);
    Weights at{sample.weights[0], sample.weights[1], sample.weights[2]};
    while (!is_leaf(*t) && !is_corner(at)) {
        const Layout& inside = layout(t->configuration);
        std::size_t slot = 0;
        Weights inner{};
        for (; slot < inside.triangle_count; ++slot) {
            inner = weights_in(inside.triangles[slot], at);
            if (std::min({inner[0], inner[1], inner[2]}) >= 0) break;
        }
        SELVEDGE_ASSERT(slot < inside.triangle_count);
        t = &cloth.mesh.triangle(t->internal_triangles[slot]);
        at = inner;
    }
    return position(cloth, *t, at);
}

// The vertices of a base triangle's division into n rows, and their numbers in the fixed mesh.
class Division {
 public:
    Division(const AdaptiveMesh& mesh, int level) : mesh_(mesh), n_(1 << level) {}

    std::size_t vertices_per_edge() const { return static_cast<std::size_t>(n_ - 1); }
    std::size_t vertices_per_triangle() const { return static_cast<std::size_t>((n_ - 1) * (n_ - 2) / 2); }
    std::size_t vertex_count() const { return first_inside() + mesh_.base_triangle_count() * vertices_per_triangle(); }

    // The number of the vertex at the weights `at`, whose sum is n.
    std::uint32_t index(std::uint32_t triangle, const Weights& at) const {
        const AdaptiveTriangle& t = mesh_.triangle(TriangleId(triangle));
        for (std::size_t k = 0; k < 3; ++k)
            if (at[k] == n_) return t.vertices[k].value;
        for (std::size_t k = 0; k < 3; ++k)
            if (at[(k + 2) % 3] == 0) return index_on_edge(t, k, at[(k + 1) % 3]);
        const int row = at[1] - 1, before = row * (n_ - 1) - row * (row + 1) / 2;
        return static_cast<std::uint32_t>(first_inside() + triangle * vertices_per_triangle() +
                                          static_cast<std::size_t>(before + at[2] - 1));
    }

    // Calls take(weights) for each vertex, take_triangle(three weights) for each triangle, anticlockwise.
    template <class Take>
    void for_each_vertex(const Take& take) const {
        for (int i = 0; i <= n_; ++i)
            for (int j = 0; i + j <= n_; ++j) take(at(i, j));
    }
    template <class Take>
    void for_each_triangle(const Take& take) const {
        for (int i = 0; i < n_; ++i)
            for (int j = 0; i + j < n_; ++j) {
                take({at(i, j), at(i + 1, j), at(i, j + 1)});
                if (i + j + 1 < n_) take({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
            }
    }

 private:
    Weights at(int i, int j) const { return {n_ - i - j, i, j}; }
    std::size_t first_inside() const {
        return mesh_.base_vertex_count() + mesh_.base_edge_count() * vertices_per_edge();
    }
    // steps: from the triangle's vertex k towards the next, 1..n-1. Numbers follow the edge's own direction.
    std::uint32_t index_on_edge(const AdaptiveTriangle& t, std::size_t k, int steps) const {
        if (mesh_.end(t.edges[k], 0) != t.vertices[k]) steps = n_ - steps;
        return static_cast<std::uint32_t>(mesh_.base_vertex_count() + t.edges[k].value * vertices_per_edge() +
                                          static_cast<std::size_t>(steps - 1));
    }

    const AdaptiveMesh& mesh_;
    int n_;
};

// In double, where each sum is exact up to one rounding: two triangles of a panel agree along their common edge.
Vec2f material_at(const AdaptiveTriangle& t, const Weights& at) {
    Vec2d u = Vec2d::Zero();
    for (std::size_t k = 0; k < 3; ++k)
        if (at[k] > 0) u += double(at[k]) * t.u[k].cast<double>();
    return (u / double(at[0] + at[1] + at[2])).cast<float>();
}

std::vector<FixedSample> samples_of(const AdaptiveMesh& mesh, const Division& division) {
    std::vector<FixedSample> samples(division.vertex_count());
    for (std::uint32_t i = 0; i < mesh.base_triangle_count(); ++i) {
        division.for_each_vertex([&](const Weights& at) {
            FixedSample& sample = samples[division.index(i, at)];
            if (sample.triangle) return;
            sample.triangle = TriangleId(i);
            for (std::size_t k = 0; k < 3; ++k) sample.weights[k] = static_cast<std::uint8_t>(at[k]);
        });
    }
    return samples;
}

void add_triangles(const AdaptiveMesh& mesh, const Division& division, DrawMesh& fixed) {
    for (std::uint32_t i = 0; i < mesh.base_triangle_count(); ++i) {
        const AdaptiveTriangle& t = mesh.triangle(TriangleId(i));
        division.for_each_triangle([&](const std::array<Weights, 3>& corners) {
            std::array<std::uint32_t, 3> vertices{};
            std::array<Vec2f, 3> u{};
            for (std::size_t k = 0; k < 3; ++k) {
                vertices[k] = division.index(i, corners[k]);
                u[k] = material_at(t, corners[k]);
            }
            fixed.triangles.push_back(vertices);
            fixed.u.push_back(u);
            fixed.panel.push_back(t.panel);
        });
    }
}

}  // namespace

FixedMesh make_fixed_mesh(const Cloth& cloth, const std::vector<std::string>& panel_names, int level) {
    SELVEDGE_ASSERT(level >= 0 && level <= kFinestFixedLevel);
    const Division division(cloth.mesh, level);
    FixedMesh fixed{.level = level, .samples = samples_of(cloth.mesh, division), .mesh = {}};
    DrawMesh& mesh = fixed.mesh;
    mesh.panel_names = panel_names;
    mesh.panel_grain_angles = cloth.material.grain_angles;
    mesh.panel_sett_offsets = cloth.material.sett_offsets;
    add_triangles(cloth.mesh, division, mesh);
    sample(fixed, cloth, mesh.x);
    if (cloth.mesh.has_right_wrong_edges()) mesh.turned_corners = find_turned_corners(mesh.triangles);
    mesh.normals = vertex_normals(mesh.x, mesh.triangles, mesh.turned_corners);
    return fixed;
}

int fixed_level_for(const Cloth& cloth, std::size_t max_triangles) {
    int level = 0;
    while (level < kFinestFixedLevel && cloth.mesh.base_triangle_count() << 2 * (level + 1) <= max_triangles) ++level;
    return level;
}

// The cost per vertex is bounded: a sample is a corner, and the descent ends, after at most `level` triangles.
void sample(const FixedMesh& fixed, const Cloth& cloth, std::vector<Vec3f>& x) {
    SELVEDGE_ASSERT(fixed.samples.size() == Division(cloth.mesh, fixed.level).vertex_count());
    x.resize(fixed.samples.size());
    for (std::size_t v = 0; v < x.size(); ++v) {
        SELVEDGE_ASSERT(fixed.samples[v].triangle);
        x[v] = position(cloth, fixed.samples[v]);
    }
}

}  // namespace selvedge::sim
