#include "sim/adaptive/panel_lines.h"

#include <algorithm>
#include <cstddef>

namespace selvedge::sim {

// An edge is a child of the edge whose centre one of its ends is, if that has it.
EdgeId base_of(const AdaptiveMesh& mesh, EdgeId e) {
    while (e && e.value >= mesh.base_edge_count()) {
        EdgeId owner;
        for (const VertexId end : mesh.edge(e).ends) {
            const EdgeId parent = mesh.vertex(end).parent;
            if (parent && std::ranges::find(mesh.edge(parent).children, e) != mesh.edge(parent).children.end())
                owner = parent;
        }
        e = owner;
    }
    return e;
}

std::array<std::optional<PanelLine>, 2> lines_of(const AdaptiveMesh& mesh, EdgeId e) {
    std::array<std::optional<PanelLine>, 2> lines;
    const EdgeId base = base_of(mesh, e);
    if (!base) return lines;
    for (std::size_t side = 0; side < 2; ++side) {
        const TriangleId t = mesh.edge(base).sides[side];
        if (!t) continue;
        const AdaptiveTriangle& triangle = mesh.triangle(t);
        const SideLine& line = mesh.base_line(t, index_of(triangle, base));
        if (!line.is_none()) lines[side] = {.panel = triangle.panel, .edge = line.edge};
    }
    return lines;
}

}  // namespace selvedge::sim
