#include "sim/inspection/worn_garment.h"

#include <algorithm>

#include "sim/core/disjoint_sets.h"
#include "sim/mesh/sew.h"
#include "sim/place/limb_pieces.h"

namespace selvedge::sim {

WornGarment undraped(GarmentMesh unsewn, const std::vector<Vec3d>& placed) {
    WornGarment garment{
        .panels = unsewn, .rises = {}, .draped = unsewn.x, .closed = unsewn, .in_closed = {}, .closed_draped = {}};
    for (std::size_t v = 0; v < placed.size(); ++v) garment.rises.push_back(unsewn.x[v].y() - placed[v].y());
    garment.in_closed = merge_seams(garment.closed);
    return garment;
}

WornGarment compare_drape(const Cloth& cloth, const GarmentMesh& sewn, WornGarment garment) {
    for (std::size_t t = 0; t < sewn.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto now = static_cast<std::size_t>(sewn.triangles[t].vertices[k]);
            garment.draped[static_cast<std::size_t>(garment.panels.triangles[t].vertices[k])] =
                cloth.x[now].head<3>().cast<double>();
        }
    }
    garment.closed_draped.assign(garment.closed.x.size(), Vec3d::Zero());
    std::vector<int> joined(garment.closed.x.size(), 0);
    for (std::size_t v = 0; v < garment.draped.size(); ++v) {
        const auto at = static_cast<std::size_t>(garment.in_closed[v]);
        garment.closed_draped[at] += garment.draped[v];
        ++joined[at];
    }
    for (std::size_t v = 0; v < joined.size(); ++v) garment.closed_draped[v] /= joined[v];
    return garment;
}

PanelVertices vertices_by_panel(const GarmentMesh& mesh) {
    PanelVertices panels(mesh.panel_names.size());
    for (const GarmentTriangle& t : mesh.triangles) {
        for (const int v : t.vertices) panels[static_cast<std::size_t>(t.panel)].push_back(static_cast<std::size_t>(v));
    }
    for (std::vector<std::size_t>& vertices : panels) {
        std::ranges::sort(vertices);
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    }
    return panels;
}

std::vector<std::size_t> garment_parts(const WornGarment& garment, const PanelVertices& panels) {
    DisjointSets parts(panels.size());
    std::vector<int> panel_at(garment.closed.x.size(), -1);
    for (std::size_t p = 0; p < panels.size(); ++p) {
        for (const std::size_t v : panels[p]) {
            int& panel = panel_at[static_cast<std::size_t>(garment.in_closed[v])];
            if (panel >= 0) parts.join(panel, static_cast<int>(p));
            panel = static_cast<int>(p);
        }
    }
    std::vector<std::size_t> first;
    for (std::size_t p = 0; p < panels.size(); ++p)
        first.push_back(static_cast<std::size_t>(parts.find(static_cast<int>(p))));
    return first;
}

std::optional<LimbKind> arm_of(const std::vector<std::size_t>& vertices, const std::vector<Vec3d>& x,
                               const BodyLimbs& body) {
    std::vector<Vec3d> points;
    for (const std::size_t v : vertices) points.push_back(x[v]);
    return arm_nearest_to(points, body, 0.5);
}

}  // namespace selvedge::sim
