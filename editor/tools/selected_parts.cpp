#include "editor/tools/selected_parts.h"

#include <cmath>

namespace selvedge {
namespace {

PlaneMap about(const Vec2d& centre, const Vec2d& x_axis, const Vec2d& y_axis) {
    return {x_axis, y_axis, centre - x_axis * centre.x() - y_axis * centre.y()};
}

}  // namespace

std::vector<PartRef> selected_vertices(const SheetGeometry& geometry, const Selection& selection) {
    std::set<PartRef> vertices = selection.vertices;
    for (const PartRef& ref : selection.edges) {
        const PanelShape* shape = geometry.find(ref.panel);
        if (shape == nullptr || geometry.edge(ref) == nullptr) continue;
        const OutlineEdge& edge = shape->panel.edges[static_cast<std::size_t>(ref.index)];
        vertices.insert({ref.panel, edge.start});
        vertices.insert({ref.panel, edge.end});
    }
    std::erase_if(vertices, [&](const PartRef& ref) { return selection.panels.contains(ref.panel); });
    return {vertices.begin(), vertices.end()};
}

std::optional<Command> move_selected(const SheetGeometry& geometry, const Selection& selection, const Vec2d& by) {
    if (!selection.panels.empty()) {
        return MovePanels{{selection.panels.begin(), selection.panels.end()}, by};
    }
    const std::vector<PartRef> vertices = selected_vertices(geometry, selection);
    if (vertices.empty()) return {};
    return MoveVertices{vertices, by};
}

std::optional<Command> transform_selected(const SheetGeometry& geometry, const Selection& selection,
                                          const PlaneMap& map, const std::string& what) {
    if (!selection.panels.empty()) {
        return TransformPanels{{selection.panels.begin(), selection.panels.end()}, map, what};
    }
    const std::vector<PartRef> vertices = selected_vertices(geometry, selection);
    if (vertices.empty()) return {};
    return TransformVertices{vertices, map, what};
}

std::set<std::string> touched_panels(const Selection& selection) {
    std::set<std::string> panels = selection.panels;
    for (const std::set<PartRef>* parts :
         {&selection.vertices, &selection.edges, &selection.internal_lines, &selection.notches}) {
        for (const PartRef& ref : *parts) panels.insert(ref.panel);
    }
    return panels;
}

PlaneMap rotation_about(const Vec2d& centre, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return about(centre, Vec2d(c, s), Vec2d(-s, c));
}

PlaneMap scaling_about(const Vec2d& centre, const Vec2d& factors) {
    return about(centre, Vec2d(factors.x(), 0), Vec2d(0, factors.y()));
}

PlaneMap mirror_over(const Vec2d& on_axis, const Vec2d& direction) {
    const Vec2d d = direction.normalized();
    return about(on_axis, Vec2d(2 * d.x() * d.x() - 1, 2 * d.x() * d.y()),
                 Vec2d(2 * d.x() * d.y(), 2 * d.y() * d.y() - 1));
}

Vec2d apply(const PlaneMap& map, const Vec2d& p) {
    return map.x_axis * p.x() + map.y_axis * p.y() + map.shift;
}

}  // namespace selvedge
