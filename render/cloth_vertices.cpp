#include "render/cloth_vertices.h"

#include <algorithm>
#include <cmath>

#include "sim/core/assert.h"

namespace selvedge {
namespace {

// One triangle's side, known by its ends in rising order.
struct EdgeUse {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    std::uint32_t triangle = 0;
    std::uint32_t edge = 0;

    auto operator<=>(const EdgeUse&) const = default;
    bool is_same_edge(const EdgeUse& other) const { return low == other.low && high == other.high; }
};

std::vector<EdgeUse> sorted_edge_uses(const PlainMesh& mesh) {
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

Vec2f material_at(const PlainMesh& mesh, std::uint32_t triangle, std::uint32_t vertex) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
        if (mesh.triangles[triangle][corner] == vertex) return mesh.u[triangle][corner];
    }
    return Vec2f::Zero();
}

bool jumps(const PlainMesh& mesh, const EdgeUse& a, const EdgeUse& b) {
    if (!mesh.panel.empty() && mesh.panel[a.triangle] != mesh.panel[b.triangle]) return true;
    if (mesh.u.empty()) return false;
    constexpr float same = 1e-4F;  // m: what a file's decimals may cost
    for (const std::uint32_t vertex : {a.low, a.high}) {
        if ((material_at(mesh, a.triangle, vertex) - material_at(mesh, b.triangle, vertex)).norm() > same) return true;
    }
    return false;
}

// Per triangle: bits 8..10 mark edges on seams, bits 11..13 edges on hems.
std::vector<std::uint32_t> mark_edges(const PlainMesh& mesh) {
    std::vector<std::uint32_t> marks(mesh.triangles.size(), 0);
    const std::vector<EdgeUse> uses = sorted_edge_uses(mesh);
    for (std::size_t first = 0; first < uses.size();) {
        std::size_t last = first + 1;
        while (last < uses.size() && uses[last].is_same_edge(uses[first])) ++last;
        const bool is_hem = last == first + 1;
        const bool is_seam = !is_hem && jumps(mesh, uses[first], uses[first + 1]);
        for (std::size_t i = first; i < last; ++i) {
            const std::uint32_t bit = 1U << uses[i].edge;
            marks[uses[i].triangle] |= (is_seam ? bit << 8 : 0U) | (is_hem ? bit << 11 : 0U);
        }
        first = last;
    }
    return marks;
}

std::array<float, 3> corner_heights(const std::array<Vec3f, 3>& x) {
    const float doubled_area = (x[1] - x[0]).cross(x[2] - x[0]).norm();
    std::array<float, 3> heights{};
    for (std::size_t i = 0; i < 3; ++i) {
        const float base = (x[(i + 2) % 3] - x[(i + 1) % 3]).norm();
        heights[i] = base > 0 ? doubled_area / base : 0;
    }
    return heights;
}

// The warp runs at `grain` from +y, counter-clockwise; the weft a quarter turn clockwise from it.
std::array<float, 2> turned_to_grain(const Vec2f& u, float grain) {
    const float c = std::cos(grain), s = std::sin(grain);
    return {c * u.x() + s * u.y(), -s * u.x() + c * u.y()};
}

float grain_of(const PlainMesh& mesh, std::size_t triangle) {
    const std::size_t panel = mesh.panel.empty() ? 0 : mesh.panel[triangle];
    return panel < mesh.panel_grain_angles.size() ? mesh.panel_grain_angles[panel] : 0.0F;
}

std::array<float, 3> to_array(const Vec3f& v) {
    return {v.x(), v.y(), v.z()};
}

}  // namespace

std::vector<ClothVertex> make_cloth_vertices(const PlainMesh& mesh, const std::vector<Vec3f>& normals,
                                             const std::vector<Openness>& openness) {
    SELVEDGE_ASSERT(normals.size() == mesh.x.size() && openness.size() == mesh.x.size());
    SELVEDGE_ASSERT(mesh.u.empty() || mesh.u.size() == mesh.triangles.size());
    const std::vector<std::uint32_t> edge_marks = mark_edges(mesh);
    std::vector<ClothVertex> vertices;
    vertices.reserve(mesh.triangles.size() * 3);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const std::array<float, 3> heights = corner_heights({mesh.x[a], mesh.x[b], mesh.x[c]});
        const std::uint32_t level = mesh.level.empty() ? 0U : mesh.level[t];
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t v = mesh.triangles[t][corner];
            ClothVertex vertex{};
            vertex.position = to_array(mesh.x[v]);
            vertex.normal = to_array(normals[v]);
            if (!mesh.u.empty()) vertex.place = turned_to_grain(mesh.u[t][corner], grain_of(mesh, t));
            vertex.heights[corner] = heights[corner];
            vertex.openness = {openness[v].front, openness[v].back};
            vertex.marks = level | edge_marks[t];
            vertices.push_back(vertex);
        }
    }
    return vertices;
}

}  // namespace selvedge
