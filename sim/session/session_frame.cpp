#include "sim/session/session_frame.h"

#include <algorithm>

#include "sim/inspection/report.h"

namespace selvedge::sim {
namespace {

void count_triangles(SessionFrame& frame, std::size_t base_triangles) {
    SessionStatistics& statistics = frame.statistics;
    statistics.base_triangles = static_cast<int>(base_triangles);
    statistics.leaf_triangles = static_cast<int>(frame.mesh.triangles.size());
    statistics.leaf_vertices = static_cast<int>(frame.mesh.x.size());
    const auto deepest = std::ranges::max_element(frame.mesh.level);
    statistics.by_level.assign(deepest == frame.mesh.level.end() ? 0 : std::size_t{*deepest} + 1, 0);
    for (const std::uint8_t level : frame.mesh.level) ++statistics.by_level[level];
}

}  // namespace

void show_placed(SessionFrame& frame, const GarmentMesh& unsewn) {
    DrawMesh& mesh = frame.mesh;
    for (const Vec3d& x : unsewn.x) mesh.x.emplace_back(x.cast<float>());
    mesh.vertex_level.assign(mesh.x.size(), 0);
    for (const GarmentTriangle& t : unsewn.triangles) {
        HierarchyTriangle base;
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] = static_cast<std::uint32_t>(t.vertices[k]);
            base.u[k] = t.u[k].cast<float>();
        }
        base.panel = static_cast<std::uint16_t>(t.panel);
        mesh.triangles.push_back(corners);
        mesh.u.push_back(base.u);
        mesh.panel.push_back(base.panel);
        mesh.level.push_back(0);
        frame.hierarchy.push_back(base);
    }
    mesh.normals = vertex_normals(mesh.x, mesh.triangles);
    mesh.panel_names = unsewn.panel_names;
    for (const double angle : unsewn.panel_grain_angles) mesh.panel_grain_angles.push_back(static_cast<float>(angle));
    for (const Vec2d& offset : unsewn.panel_sett_offsets) mesh.panel_sett_offsets.push_back(offset.cast<float>());
    add_seam_lines(frame, unsewn.links, unsewn.x);
    count_triangles(frame, unsewn.triangles.size());
}

void show_cloth(SessionFrame& frame, const Cloth& cloth, const std::vector<std::string>& panel_names) {
    frame.mesh = draw_mesh(cloth, panel_names);
    frame.hierarchy = triangle_hierarchy(cloth);
    count_triangles(frame, cloth.mesh.base_triangle_count());
}

}  // namespace selvedge::sim
