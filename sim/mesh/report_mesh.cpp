#include "sim/mesh/report_mesh.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <utility>

#include "sim/core/assert.h"
#include "sim/mesh/planar.h"
#include "sim/pattern/outline.h"

namespace selvedge {
namespace {

using EdgeEnds = std::pair<int, int>;  // lower vertex first

EdgeEnds edge_of(const GarmentTriangle& triangle, std::size_t k) {
    return std::minmax({triangle.vertices[k], triangle.vertices[(k + 1) % 3]});
}

// Both meshes have the same triangles: an edge that two triangles share after sewing but not before lies on a seam.
int count_seam_edges(const GarmentMesh& unsewn, const GarmentMesh& sewn) {
    SELVEDGE_ASSERT(unsewn.triangles.size() == sewn.triangles.size());
    std::map<EdgeEnds, EdgeEnds> unsewn_edge;
    int count = 0;
    for (std::size_t t = 0; t < sewn.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const EdgeEnds own = edge_of(unsewn.triangles[t], k);
            const auto [other, is_new] = unsewn_edge.emplace(edge_of(sewn.triangles[t], k), own);
            if (!is_new && other->second != own) ++count;
        }
    }
    return count;
}

void measure_angles(const GarmentMesh& mesh, MeshReport& report) {
    double smallest = std::numbers::pi;
    for (const GarmentTriangle& triangle : mesh.triangles) {
        const double angle = smallest_angle(triangle.u[0], triangle.u[1], triangle.u[2]);
        if (angle >= smallest) continue;
        smallest = angle;
        report.min_angle_panel = mesh.panel_names[static_cast<std::size_t>(triangle.panel)];
    }
    report.min_angle_deg = mesh.triangles.empty() ? 0 : smallest * 180 / std::numbers::pi;
}

double side_length(const Pattern& pattern, const SeamSide& side) {
    const Panel& panel = pattern.panels[static_cast<std::size_t>(side.panel)];
    return outline_length(panel, panel.edges[static_cast<std::size_t>(side.edge)]);
}

std::optional<SeamMismatch> worst_mismatch(const Pattern& pattern) {
    std::optional<SeamMismatch> worst;
    for (std::size_t i = 0; i < pattern.seams.size(); ++i) {
        const double first = side_length(pattern, pattern.seams[i].first);
        const double second = side_length(pattern, pattern.seams[i].second);
        const auto [shorter, longer] = std::minmax(first, second);
        if (!worst || longer > worst->ratio * shorter) {
            worst = SeamMismatch{static_cast<int>(i), longer / shorter, longer - shorter};
        }
    }
    return worst;
}

}  // namespace

MeshReport report_mesh(const Pattern& pattern, const GarmentMesh& unsewn, const GarmentMesh& sewn) {
    MeshReport report;
    report.triangles = static_cast<int>(sewn.triangles.size());
    report.vertices = static_cast<int>(sewn.x.size());
    report.seam_edges = count_seam_edges(unsewn, sewn);
    report.worst_mismatch = worst_mismatch(pattern);
    measure_angles(sewn, report);
    return report;
}

}  // namespace selvedge
