#include <cmath>

#include "editor/tools/curve_shape.h"
#include "editor/tools/outline_tools.h"
#include "editor/tools/overlay_parts.h"
#include "editor/tools/selected_parts.h"

namespace selvedge {

PickOptions CurveTool::wanted(const ToolContext& context) const {
    PickOptions options = pick_options(context);
    options.vertices = options.notches = options.internal_lines = false;
    std::set<std::string> panels = touched_panels(context.document.selection());
    options.handle_edges = curved_edges_of(context.geometry, panels);
    return options;
}

void CurveTool::press(ToolContext& context, const SheetPointer& pointer) {
    is_dragging_ = false;
    pressed_ = pick(context.geometry, pointer.at, wanted(context));
    if (const PanelShape* shape = context.geometry.find(pressed_.panel)) before_ = shape->panel;
}

void CurveTool::click(ToolContext& context, const SheetPointer&) {
    Selection selection;
    if (pressed_.kind == PickKind::Edge || pressed_.kind == PickKind::Handle) selection.edges.insert(pressed_.ref());
    if (pressed_.kind == PickKind::Panel) selection.panels.insert(pressed_.panel);
    context.document.select(selection);
}

void CurveTool::drag(ToolContext& context, const SheetPointer& pointer) {
    const PanelShape* shape = context.geometry.find(pressed_.panel);
    if (shape == nullptr || (pressed_.kind != PickKind::Edge && pressed_.kind != PickKind::Handle)) return;
    if (!is_dragging_) {
        Selection selection;
        selection.edges.insert(pressed_.ref());
        context.document.select(selection);
    }
    is_dragging_ = true;
    const Vec2d to = shape->in_panel(pointer.at);
    OutlineEdge curve = before_.edges.at(static_cast<std::size_t>(pressed_.index));
    if (pressed_.kind == PickKind::Handle) {
        curve.control.at(static_cast<std::size_t>(pressed_.control)) = to;
    } else if (pointer.modifiers.alt) {
        curve = arc_through(before_, curve, to);
    } else {
        if (curve.kind == CurveKind::Arc && pointer.modifiers.shift) curve.kind = CurveKind::Line;
        if (pointer.modifiers.shift) curve = as_cubic_edge(before_, curve);
        curve = bent_through(before_, curve, pressed_.t, to);
    }
    context.document.attempt(SetCurve{pressed_.panel, pressed_.index, curve});
}

void CurveTool::drop(ToolContext& context, const SheetPointer&) {
    is_dragging_ = false;
    context.document.keep();
}

// Straight again.
void CurveTool::double_click(ToolContext& context, const SheetPointer& pointer) {
    const Pick picked = pick(context.geometry, pointer.at, wanted(context));
    if (picked.kind == PickKind::Edge) context.document.run(SetCurve{picked.panel, picked.index, OutlineEdge{}});
}

bool CurveTool::cancel(ToolContext&) {
    const bool was_dragging = is_dragging_;
    is_dragging_ = false;
    return was_dragging;
}

void CurveTool::draw(const ToolContext& context, ToolOverlay& overlay) const {
    overlay.handle_edges = wanted(context).handle_edges;
    overlay.shows_vertices = true;
    if (!is_dragging_) return EdgeTool::draw(context, overlay);
    const EdgeShape* edge = context.geometry.edge(pressed_.ref());
    const PanelShape* shape = context.geometry.find(pressed_.panel);
    if (edge == nullptr || shape == nullptr) return;
    add_edge(overlay, context.geometry, pressed_.ref(), OverlayTone::Draft);
    const OutlineEdge& curve = shape->panel.edges.at(static_cast<std::size_t>(pressed_.index));
    overlay.readout = {in_cm(edge->length)};
    if (curve.kind == CurveKind::Arc) overlay.readout.push_back("radius " + in_cm(curve.arc_radius));
}

std::string CurveTool::hint(const ToolContext&) const {
    return "Drag an edge to bend it; Shift: with two handles, Alt: a circle's arc; double click: straight";
}

}  // namespace selvedge
