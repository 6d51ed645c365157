#include "render/cloth_vertices.h"

#include <cmath>

#include "render/edge_marks.h"
#include "sim/core/assert.h"

namespace selvedge {
namespace {

// The warp runs at `grain` from +y, counter-clockwise; the weft a quarter turn clockwise from it. The sett's offset
// comes after the turn.
std::array<float, 2> turned_to_grain(const Vec2f& u, float grain, const Vec2f& offset) {
    const float c = std::cos(grain), s = std::sin(grain);
    return {c * u.x() + s * u.y() + offset.x(), -s * u.x() + c * u.y() + offset.y()};
}

float grain_of(const PlainMesh& mesh, std::size_t triangle) {
    const std::size_t panel = mesh.panel.empty() ? 0 : mesh.panel[triangle];
    return panel < mesh.panel_grain_angles.size() ? mesh.panel_grain_angles[panel] : 0.0F;
}

Vec2f sett_offset_of(const PlainMesh& mesh, std::size_t triangle) {
    const std::size_t panel = mesh.panel.empty() ? 0 : mesh.panel[triangle];
    return panel < mesh.panel_sett_offsets.size() ? mesh.panel_sett_offsets[panel] : Vec2f(0, 0);
}

std::array<float, 3> to_array(const Vec3f& v) {
    return {v.x(), v.y(), v.z()};
}

}  // namespace

std::vector<ClothVertex> make_cloth_vertices(const PlainMesh& mesh, const std::vector<Vec3f>& normals,
                                             const std::vector<Openness>& openness) {
    SELVEDGE_ASSERT(normals.size() == mesh.x.size() && openness.size() == mesh.x.size());
    SELVEDGE_ASSERT(mesh.u.empty() || mesh.u.size() == mesh.triangles.size());
    const std::vector<TriangleMarks> marks = mark_edges(mesh);
    const std::vector<std::array<TouchDistance, 3>> touches = touch_distances(mesh, marks);
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
            if (!mesh.u.empty()) {
                vertex.place = turned_to_grain(mesh.u[t][corner], grain_of(mesh, t), sett_offset_of(mesh, t));
            }
            vertex.heights[corner] = heights[corner];
            vertex.openness = {openness[v].front, openness[v].back};
            vertex.touch = {touches[t][corner].seam, touches[t][corner].hem};
            vertex.marks = level | marks[t].seam << 8 | marks[t].hem << 11;
            vertices.push_back(vertex);
        }
    }
    return vertices;
}

}  // namespace selvedge
