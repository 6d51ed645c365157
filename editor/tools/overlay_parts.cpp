#include "editor/tools/overlay_parts.h"

#include <algorithm>

#include "editor/tools/sheet_pick.h"

namespace selvedge {

void add_guides(ToolOverlay& overlay, const Snap& snapped) {
    for (const SnapGuide& guide : snapped.guides) {
        overlay.lines.push_back({.points = {guide.from, guide.to}, .tone = OverlayTone::Guide, .is_dashed = true});
        overlay.handles.push_back({guide.from, HandleShape::Cross, OverlayTone::Guide, false});
    }
    if (snapped.kind == SnapKind::Point) {
        overlay.handles.push_back({snapped.point, HandleShape::Round, OverlayTone::Guide, false});
    }
    if (snapped.kind == SnapKind::Midpoint) {
        overlay.handles.push_back({snapped.point, HandleShape::Diamond, OverlayTone::Guide, false});
    }
}

std::vector<Vec2d> part_of_edge(const PanelShape& shape, int edge, double from, double to) {
    const EdgeShape& line = shape.edges.at(static_cast<std::size_t>(edge));
    const double low = std::min(from, to), high = std::max(from, to);
    std::vector<Vec2d> points{shape.on_sheet(line.at(low))};
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const bool is_between = line.reached[i] > low * line.length && line.reached[i] < high * line.length;
        if (is_between) points.push_back(shape.on_sheet(line.points[i]));
    }
    points.push_back(shape.on_sheet(line.at(high)));
    if (from > to) std::reverse(points.begin(), points.end());
    return points;
}

void add_edge(ToolOverlay& overlay, const SheetGeometry& geometry, const PartRef& edge, OverlayTone tone) {
    const PanelShape* shape = geometry.find(edge.panel);
    if (shape == nullptr || geometry.edge(edge) == nullptr) return;
    overlay.lines.push_back({.points = part_of_edge(*shape, edge.index, 0, 1), .tone = tone});
}

void add_box(ToolOverlay& overlay, const SheetBox& box, OverlayTone tone) {
    if (box.isEmpty()) return;
    const Vec2d low = box.min(), high = box.max();
    overlay.lines.push_back({.points = {low, Vec2d(high.x(), low.y()), high, Vec2d(low.x(), high.y()), low},
                             .tone = tone,
                             .is_closed = true});
}

std::set<PartRef> curved_edges_of(const SheetGeometry& geometry, const std::set<std::string>& panels) {
    std::set<PartRef> edges;
    for (const std::string& name : panels) {
        const PanelShape* shape = geometry.find(name);
        if (shape == nullptr) continue;
        for (std::size_t i = 0; i < shape->panel.edges.size(); ++i) {
            if (control_count(shape->panel.edges[i].kind) > 0) edges.insert({name, static_cast<int>(i)});
        }
    }
    return edges;
}

}  // namespace selvedge
