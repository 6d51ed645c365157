#include "sim/paper/joined_path.h"

#include <algorithm>

#include "sim/paper/path_builder.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {

std::vector<Vec2d> points_of_path(const DrawnPath& path) {
    constexpr int kSteps = 16;
    const Panel shape = as_panel(path);
    std::vector<Vec2d> points{path.vertices[as_size(path.edges.front().start)]};
    for (const OutlineEdge& edge : path.edges) {
        const int steps = edge.kind == CurveKind::Line ? 1 : kSteps;
        for (int i = 1; i < steps; ++i) points.push_back(outline_point(shape, edge, i / static_cast<double>(steps)));
        points.push_back(path.vertices[as_size(edge.end)]);
    }
    return points;
}

DrawnPath joined_path(const std::vector<const DrawnPath*>& paths, const ClosedChain& chain) {
    DrawnPath outline = *paths.front();
    outline.vertices.clear();
    outline.edges.clear();
    for (std::size_t k = 0; k < chain.size(); ++k) {
        DrawnPath path = *paths[k];
        if (chain[k].is_reversed) {
            std::ranges::reverse(path.edges);
            for (OutlineEdge& edge : path.edges) edge = reversed_edge(edge);
        }
        for (OutlineEdge& edge : path.edges) {
            outline.vertices.push_back(path.vertices[as_size(edge.start)]);
            edge.start = static_cast<int>(outline.vertices.size()) - 1;
            edge.end = edge.start + 1;
            outline.edges.push_back(edge);
        }
    }
    outline.edges.back().end = 0;
    outline.is_closed = true;
    return outline;
}

}  // namespace selvedge::sim
