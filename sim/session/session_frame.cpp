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
    frame.mesh = draw_mesh(unsewn);
    for (std::size_t t = 0; t < unsewn.triangles.size(); ++t)
        frame.hierarchy.push_back({.u = frame.mesh.u[t], .panel = frame.mesh.panel[t]});
    add_seam_lines(frame, unsewn.links, unsewn.x);
    count_triangles(frame, unsewn.triangles.size());
}

void show_cloth(SessionFrame& frame, const Cloth& cloth, const std::vector<std::string>& panel_names) {
    frame.mesh = draw_mesh(cloth, panel_names);
    frame.hierarchy = triangle_hierarchy(cloth);
    count_triangles(frame, cloth.mesh.base_triangle_count());
}

}  // namespace selvedge::sim
