#include "sim/exchange/panel_parts.h"

#include <algorithm>
#include <cstddef>

#include "sim/core/assert.h"

namespace selvedge {

namespace {

constexpr std::uint32_t kNone = UINT32_MAX;

// The part's copies of one vertex, chained: few, as a vertex has few material coordinates in one panel.
struct Copies {
    std::vector<std::uint32_t> first;  // per vertex of the mesh
    std::vector<std::uint32_t> next;   // per vertex of the part
};

std::uint32_t part_vertex(PanelPart& part, Copies& copies, std::uint32_t vertex, const Vec2f* u) {
    for (std::uint32_t copy = copies.first[vertex]; copy != kNone; copy = copies.next[copy])
        if (!u || part.u[copy] == *u) return copy;
    const std::uint32_t added = std::uint32_t(part.vertices.size());
    part.vertices.push_back(vertex);
    if (u) part.u.push_back(*u);
    copies.next.push_back(copies.first[vertex]);
    copies.first[vertex] = added;
    return added;
}

std::size_t panel_of(const PlainMesh& mesh, std::size_t triangle) {
    return mesh.panel.empty() ? 0 : mesh.panel[triangle];
}

std::string panel_name(const PlainMesh& mesh, std::size_t panel) {
    return panel < mesh.panel_names.size() ? mesh.panel_names[panel] : "panel" + std::to_string(panel);
}

}  // namespace

std::vector<PanelPart> split_by_panel(const PlainMesh& mesh) {
    SELVEDGE_ASSERT(mesh.panel.empty() || mesh.panel.size() == mesh.triangles.size());
    SELVEDGE_ASSERT(mesh.u.empty() || mesh.u.size() == mesh.triangles.size());
    std::vector<std::vector<std::size_t>> triangles_of_panel;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::size_t panel = panel_of(mesh, t);
        if (panel >= triangles_of_panel.size()) triangles_of_panel.resize(panel + 1);
        triangles_of_panel[panel].push_back(t);
    }
    std::vector<PanelPart> parts;
    for (std::size_t panel = 0; panel < triangles_of_panel.size(); ++panel) {
        if (triangles_of_panel[panel].empty()) continue;
        PanelPart part;
        part.name = panel_name(mesh, panel);
        if (panel < mesh.panel_grain_angles.size()) part.grain_angle = mesh.panel_grain_angles[panel];
        if (panel < mesh.panel_sett_offsets.size()) part.sett_offset = mesh.panel_sett_offsets[panel];
        Copies copies{std::vector<std::uint32_t>(mesh.x.size(), kNone), {}};
        for (const std::size_t t : triangles_of_panel[panel]) {
            std::array<std::uint32_t, 3> corners{};
            for (std::size_t k = 0; k < 3; ++k) {
                SELVEDGE_ASSERT(mesh.triangles[t][k] < mesh.x.size());
                corners[k] = part_vertex(part, copies, mesh.triangles[t][k], mesh.u.empty() ? nullptr : &mesh.u[t][k]);
            }
            part.triangles.push_back(corners);
        }
        parts.push_back(std::move(part));
    }
    return parts;
}

}  // namespace selvedge
