#include "sim/mesh/assemble.h"

#include <algorithm>

#include "sim/core/assert.h"
#include "sim/mesh/panel_mesh.h"
#include "sim/mesh/sample_outline.h"
#include "sim/mesh/separate_edges.h"
#include "sim/mesh/triangulate.h"

namespace selvedge {
namespace {

// Where each panel's vertices begin in the garment's.
struct PlacedPanels {
    std::vector<PanelMesh> meshes;
    std::vector<int> first_vertex;
};

PanelMesh cut_or_kept(const Panel& panel, const std::vector<int>& segments, const MeshOptions& options,
                      const std::vector<KeptPanelMesh>& kept) {
    const auto is_same = [&](const KeptPanelMesh& one) {
        return one.segments == segments && one.options == options && one.vertices == panel.vertices &&
               one.edges == panel.edges;
    };
    const auto found = std::ranges::find_if(kept, is_same);
    if (found != kept.end()) return found->mesh;
    return triangulate(panel, segments,
                       {.target_edge = options.target_edge,
                        .relaxations = options.relaxations,
                        .max_triangles = options.max_triangles});
}

PlacedPanels triangulate_panels(const Pattern& pattern, const MeshOptions& options, std::vector<KeptPanelMesh>& kept) {
    const std::vector<std::vector<int>> segments = count_segments(pattern, options);
    std::vector<KeptPanelMesh> fresh;
    PlacedPanels placed;
    int vertices = 0;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
        const Panel& panel = pattern.panels[p];
        placed.meshes.push_back(cut_or_kept(panel, segments[p], options, kept));
        fresh.push_back({panel.vertices, panel.edges, segments[p], options, placed.meshes.back()});
        placed.first_vertex.push_back(vertices);
        vertices += static_cast<int>(placed.meshes.back().u.size());
    }
    kept = std::move(fresh);
    return placed;
}

void add_panel(GarmentMesh& garment, const Panel& panel, const PanelMesh& mesh) {
    const auto first = static_cast<int>(garment.x.size());
    const auto index = static_cast<int>(garment.panel_names.size());
    for (const Vec2d& u : mesh.u) garment.x.push_back(panel.place(u));
    for (const auto& corners : mesh.triangles) {
        GarmentTriangle triangle;
        triangle.panel = index;
        for (std::size_t k = 0; k < 3; ++k) {
            triangle.vertices[k] = first + corners[k];
            triangle.u[k] = mesh.u[static_cast<std::size_t>(corners[k])];
        }
        garment.triangles.push_back(triangle);
    }
    for (std::size_t e = 0; e < panel.edges.size(); ++e) {
        if (std::ranges::find(panel.pins, panel.edges[e].start) == panel.pins.end()) continue;
        garment.pins.push_back(first + mesh.outline[static_cast<std::size_t>(mesh.runs[e].first)]);
    }
    garment.panel_names.push_back(panel.name);
    garment.panel_grain_angles.push_back(panel.grain_angle);
    garment.panel_sett_offsets.push_back(panel.sett_offset);
}

// The garment's vertex at sample i of an outline edge, 0 <= i <= its number of segments.
int sample_vertex(const PlacedPanels& placed, const SeamSide& side, int i) {
    const auto panel = static_cast<std::size_t>(side.panel);
    const PanelMesh& mesh = placed.meshes[panel];
    const auto at = static_cast<std::size_t>(mesh.runs[static_cast<std::size_t>(side.edge)].first + i);
    return placed.first_vertex[panel] + mesh.outline[at % mesh.outline.size()];
}

int segments_of(const PlacedPanels& placed, const SeamSide& side) {
    return placed.meshes[static_cast<std::size_t>(side.panel)].runs[static_cast<std::size_t>(side.edge)].segments;
}

// A dart's tip is one vertex on both sides and needs no link.
void link_seam(GarmentMesh& garment, const PlacedPanels& placed, const Seam& seam, int index) {
    const int segments = segments_of(placed, seam.first);
    SELVEDGE_ASSERT(segments == segments_of(placed, seam.second));
    for (int i = 0; i <= segments; ++i) {
        const int a = sample_vertex(placed, seam.first, i);
        const int b = sample_vertex(placed, seam.second, seam.is_reversed ? segments - i : i);
        if (a != b) garment.links.push_back({a, b, index});
    }
}

}  // namespace

GarmentMesh assemble(const Pattern& pattern, const MeshOptions& options) {
    std::vector<KeptPanelMesh> none;
    return assemble(pattern, options, none);
}

GarmentMesh assemble(const Pattern& pattern, const MeshOptions& options, std::vector<KeptPanelMesh>& kept) {
    const PlacedPanels placed = triangulate_panels(pattern, options, kept);
    GarmentMesh garment;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) add_panel(garment, pattern.panels[p], placed.meshes[p]);
    for (std::size_t s = 0; s < pattern.seams.size(); ++s) {
        link_seam(garment, placed, pattern.seams[s], static_cast<int>(s));
    }
    separate_coinciding_edges(garment);
    return garment;
}

}  // namespace selvedge
