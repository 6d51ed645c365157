#include "render/surface/creases.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/core/assert.h"

namespace selvedge::render {
namespace {

// Union-find over corners of base triangles: corners are joined where the surface is smooth across an edge.
class SmoothParts {
 public:
    explicit SmoothParts(std::size_t corners) : joined_(corners) { std::iota(joined_.begin(), joined_.end(), 0U); }
    std::uint32_t find(std::uint32_t corner) {
        while (joined_[corner] != corner) corner = joined_[corner] = joined_[joined_[corner]];
        return corner;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = find(a), b = find(b);
        joined_[std::max(a, b)] = std::min(a, b);
    }

 private:
    std::vector<std::uint32_t> joined_;
};

std::uint32_t corner_of(const sim::AdaptiveMesh& mesh, sim::TriangleId t, sim::VertexId v) {
    return 3 * t.value + static_cast<std::uint32_t>(corner_at(mesh.triangle(t), v));
}

void make_unit(std::map<SidedVertex, Vec4f>& normals) {
    for (auto& [vertex, normal] : normals) {
        const float length = normal.norm();
        normal = length > 0 ? Vec4f(normal / length) : Vec4f(Vec4f::UnitY());
    }
}

Vec4f area_of(const std::array<sim::VertexId, 3>& v, const std::vector<Vec4f>& x) {
    const Vec4f& a = x[v[0].value];
    return (x[v[1].value] - a).cross3(x[v[2].value] - a);
}

// The component of d along the line in which the planes of two normals meet; in the plane of their mean if the normals
// are nearly equal.
Vec4f along_both(const Vec4f& d, const Vec4f& first, const Vec4f& second) {
    constexpr float kNearlyOne = 1e-3F;
    const Vec4f line = first.cross3(second);
    const float squared = line.squaredNorm();
    if (squared > kNearlyOne * kNearlyOne) return line * (d.dot(line) / squared);
    const Vec4f mean = (first + second).normalized();
    return d - mean * d.dot(mean);
}

}  // namespace

Creases find_creases(const sim::AdaptiveMesh& mesh, std::span<const CreaseEdge> edges) {
    Creases creases;
    if (edges.empty()) return creases;
    creases.is_crease.resize(mesh.base_edge_count());
    creases.is_creased.resize(mesh.base_vertex_count());
    std::vector<CreaseEdge> wanted(edges.begin(), edges.end());
    for (CreaseEdge& edge : wanted) std::sort(edge.begin(), edge.end());
    std::sort(wanted.begin(), wanted.end());
    SmoothParts parts(3 * mesh.base_triangle_count());
    for (std::uint32_t i = 0; i < mesh.base_edge_count(); ++i) {
        const sim::AdaptiveEdge& edge = mesh.edge(sim::EdgeId(i));
        CreaseEdge ends{static_cast<int>(edge.ends[0].value), static_cast<int>(edge.ends[1].value)};
        std::sort(ends.begin(), ends.end());
        creases.is_crease[i] = std::binary_search(wanted.begin(), wanted.end(), ends);
        SELVEDGE_ASSERT(!creases.is_crease[i] || (edge.sides[0] && edge.sides[1]));
        for (const sim::VertexId v : edge.ends) {
            if (creases.is_crease[i]) {
                creases.is_creased[v.value] = true;
            } else if (edge.sides[0] && edge.sides[1]) {
                parts.join(corner_of(mesh, edge.sides[0], v), corner_of(mesh, edge.sides[1], v));
            }
        }
    }
    for (std::uint32_t t = 0; t < mesh.base_triangle_count(); ++t) {
        creases.corner_side.push_back({parts.find(3 * t), parts.find(3 * t + 1), parts.find(3 * t + 2)});
        creases.base_of.emplace_back(t);
    }
    return creases;
}

void note_children(Creases& creases, const sim::AdaptiveMesh& mesh, sim::TriangleId t) {
    creases.base_of.resize(std::max(creases.base_of.size(), mesh.triangles().capacity()));
    const sim::AdaptiveTriangle& owner = mesh.triangle(t);
    for (std::size_t i = 0; i < layout(owner.configuration).triangle_count; ++i)
        creases.base_of[owner.internal_triangles[i].value] = creases.base_of[t.value];
}

std::optional<SidedVertex> sided(const Creases& creases, const sim::AdaptiveMesh& mesh, sim::VertexId v,
                                 sim::EdgeId root, sim::TriangleId base) {
    if (v.value < mesh.base_vertex_count()) {
        if (!creases.is_creased[v.value]) return {};
        return SidedVertex{v, creases.corner_side[base.value][corner_at(mesh.triangle(base), v)]};
    }
    if (root.value >= creases.is_crease.size() || !creases.is_crease[root.value]) return {};
    return SidedVertex{v, mesh.edge(root).sides[0] == base ? 0U : 1U};
}

void update_base_normals(Creases& creases, const sim::AdaptiveMesh& mesh, const std::vector<Vec4f>& x) {
    creases.normals.clear();
    for (std::uint32_t t = 0; t < mesh.base_triangle_count(); ++t) {
        const std::array<sim::VertexId, 3>& vertices = mesh.triangle(sim::TriangleId(t)).vertices;
        for (std::size_t k = 0; k < 3; ++k) {
            if (!creases.is_creased[vertices[k].value]) continue;
            Vec4f& sum =
                creases.normals.try_emplace({vertices[k], creases.corner_side[t][k]}, Vec4f::Zero()).first->second;
            sum += area_of(vertices, x);
        }
    }
    make_unit(creases.normals);
}

void update_light_normals(Creases& creases, const sim::AdaptiveMesh& mesh, const std::vector<sim::EdgeId>& roots,
                          const std::vector<Vec4f>& x) {
    creases.light_normals.clear();
    for (const sim::LeafTriangle& t : mesh.leaf_triangles()) {
        for (const sim::VertexId v : t.v) {
            const auto vertex = sided(creases, mesh, v, roots[v.value], creases.base_of[t.triangle.value]);
            if (vertex) creases.light_normals.try_emplace(*vertex, Vec4f::Zero()).first->second += area_of(t.v, x);
        }
    }
    make_unit(creases.light_normals);
}

EdgeCurve make_crease_curve(const CurveEnds& first, const CurveEnds& second, const CurveModifier& modifier) {
    const Vec4f d = first.b - first.a;
    return bent_curve(first, along_both(d, first.normal_a, second.normal_a) - d,
                      d - along_both(d, first.normal_b, second.normal_b), modifier);
}

}  // namespace selvedge::render
