#include "render/draw/edge_marks.h"

#include <algorithm>
#include <cmath>

#include "sim/core/assert.h"

namespace selvedge::render {
namespace {

// One triangle's use of an edge, identified by the edge's vertices in ascending order.
struct EdgeUse {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    std::uint32_t triangle = 0;
    std::uint32_t edge = 0;

    auto operator<=>(const EdgeUse&) const = default;
    bool is_same_edge(const EdgeUse& other) const { return low == other.low && high == other.high; }
};

std::vector<EdgeUse> sorted_edge_uses(const sim::DrawMesh& mesh) {
    std::vector<EdgeUse> uses;
    uses.reserve(mesh.triangles.size() * 3);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::uint32_t edge = 0; edge < 3; ++edge) {
            const std::uint32_t a = mesh.triangles[t][(edge + 1) % 3];
            const std::uint32_t b = mesh.triangles[t][(edge + 2) % 3];
            uses.push_back({std::min(a, b), std::max(a, b), t, edge});
        }
    }
    std::sort(uses.begin(), uses.end());
    return uses;
}

Vec2f material_at(const sim::DrawMesh& mesh, std::uint32_t triangle, std::uint32_t vertex) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
        if (mesh.triangles[triangle][corner] == vertex) return mesh.u[triangle][corner];
    }
    return Vec2f::Zero();
}

bool jumps(const sim::DrawMesh& mesh, const EdgeUse& a, const EdgeUse& b) {
    if (panel_of(mesh, a.triangle) != panel_of(mesh, b.triangle)) return true;
    if (mesh.u.empty()) return false;
    constexpr float same = 1e-4F;  // m: rounding by the number of decimals in a file
    for (const std::uint32_t vertex : {a.low, a.high}) {
        if ((material_at(mesh, a.triangle, vertex) - material_at(mesh, b.triangle, vertex)).norm() > same) return true;
    }
    return false;
}

using MarkKind = std::uint32_t TriangleMarks::*;
using TouchKind = float TouchDistance::*;

// Distances of vertices from one kind of marked edge.
struct MarkedVertices {
    std::vector<bool> is_on;
    std::vector<float> distance;  // m; of vertices opposite to a marked edge, else kFar
};

MarkedVertices find_marked(const sim::DrawMesh& mesh, const std::vector<TriangleMarks>& marks, MarkKind kind) {
    MarkedVertices marked{.is_on = std::vector<bool>(mesh.x.size(), false),
                          .distance = std::vector<float>(mesh.x.size(), TouchDistance::kFar)};
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& vertices = mesh.triangles[t];
        const std::array<float, 3> heights =
            corner_heights({mesh.x[vertices[0]], mesh.x[vertices[1]], mesh.x[vertices[2]]});
        for (std::size_t edge = 0; edge < 3; ++edge) {
            if ((marks[t].*kind >> edge & 1U) == 0) continue;
            marked.is_on[vertices[(edge + 1) % 3]] = true;
            marked.is_on[vertices[(edge + 2) % 3]] = true;
            float& distance = marked.distance[vertices[edge]];
            distance = std::min(distance, heights[edge]);
        }
    }
    return marked;
}

void add_touches(const sim::DrawMesh& mesh, const std::vector<TriangleMarks>& marks, MarkKind mark_kind,
                 TouchKind touch_kind, std::vector<std::array<TouchDistance, 3>>& touches) {
    const MarkedVertices marked = find_marked(mesh, marks, mark_kind);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& vertices = mesh.triangles[t];
        const auto is_on = [&](std::uint32_t vertex) { return bool(marked.is_on[vertex]); };
        if (marks[t].*mark_kind != 0 || std::count_if(vertices.begin(), vertices.end(), is_on) != 1) continue;
        const Vec3f touched = mesh.x[*std::find_if(vertices.begin(), vertices.end(), is_on)];
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t v = vertices[corner];
            const float beside = std::min(marked.distance[v], (mesh.x[v] - touched).norm());
            touches[t][corner].*touch_kind = is_on(v) ? 0.0F : beside;
        }
    }
}

}  // namespace

std::array<float, 3> corner_heights(const std::array<Vec3f, 3>& x) {
    const float doubled_area = (x[1] - x[0]).cross(x[2] - x[0]).norm();
    std::array<float, 3> heights{};
    for (std::size_t i = 0; i < 3; ++i) {
        const float base = (x[(i + 2) % 3] - x[(i + 1) % 3]).norm();
        heights[i] = base > 0 ? doubled_area / base : 0;
    }
    return heights;
}

std::vector<TriangleMarks> mark_edges(const sim::DrawMesh& mesh) {
    std::vector<TriangleMarks> marks(mesh.triangles.size());
    const std::vector<EdgeUse> uses = sorted_edge_uses(mesh);
    for (std::size_t first = 0; first < uses.size();) {
        std::size_t last = first + 1;
        while (last < uses.size() && uses[last].is_same_edge(uses[first])) ++last;
        const bool is_hem = last == first + 1;
        const bool is_seam = !is_hem && jumps(mesh, uses[first], uses[first + 1]);
        for (std::size_t i = first; i < last; ++i) {
            const std::uint32_t bit = 1U << uses[i].edge;
            if (is_seam) marks[uses[i].triangle].seam |= bit;
            if (is_hem) marks[uses[i].triangle].hem |= bit;
        }
        first = last;
    }
    return marks;
}

std::vector<std::array<TouchDistance, 3>> touch_distances(const sim::DrawMesh& mesh,
                                                          const std::vector<TriangleMarks>& marks) {
    SELVEDGE_ASSERT(marks.size() == mesh.triangles.size());
    std::vector<std::array<TouchDistance, 3>> touches(mesh.triangles.size());
    add_touches(mesh, marks, &TriangleMarks::seam, &TouchDistance::seam, touches);
    add_touches(mesh, marks, &TriangleMarks::hem, &TouchDistance::hem, touches);
    return touches;
}

}  // namespace selvedge::render
