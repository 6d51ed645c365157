#include "editor/tools/edit_point_tool.h"

#include "editor/tools/overlay_parts.h"
#include "editor/tools/selected_parts.h"

namespace selvedge {
namespace {

std::set<PartRef> shown_handles(const ToolContext& context) {
    std::set<std::string> panels = touched_panels(context.document.selection());
    return curved_edges_of(context.geometry, panels);
}

}  // namespace

PickOptions EditPointTool::wanted(const ToolContext& context) const {
    PickOptions options = pick_options(context);
    options.handle_edges = shown_handles(context);
    return options;
}

Selection EditPointTool::boxed(const ToolContext& context) const {
    return in_box(context.geometry, box(), BoxRule::Inside, BoxTargets::Vertices);
}

void EditPointTool::press(ToolContext& context, const SheetPointer& pointer) {
    SelectTool::press(context, pointer);
    is_dragging_part_ = false;
    const PanelShape* shape = context.geometry.find(pressed_.panel);
    if (shape == nullptr) return;
    if (pressed_.kind == PickKind::Handle) curve_ = shape->panel.edges.at(static_cast<std::size_t>(pressed_.index));
    if (pressed_.kind != PickKind::InternalLine) return;
    line_ = shape->panel.internal_lines.at(static_cast<std::size_t>(pressed_.index));
    const Vec2d u = shape->in_panel(pointer.at);
    line_point_ = 0;
    for (std::size_t i = 1; i < line_.points.size(); ++i) {
        if ((line_.points[i] - u).norm() < (line_.points[line_point_] - u).norm()) line_point_ = i;
    }
}

void EditPointTool::drag(ToolContext& context, const SheetPointer& pointer) {
    is_dragging_part_ = pressed_.kind == PickKind::Handle || pressed_.kind == PickKind::InternalLine;
    if (pressed_.kind == PickKind::Handle) return drag_handle(context, pointer);
    if (pressed_.kind == PickKind::InternalLine) return drag_line_point(context, pointer);
    SelectTool::drag(context, pointer);
}

void EditPointTool::drag_handle(ToolContext& context, const SheetPointer& pointer) {
    const PanelShape* shape = context.geometry.find(pressed_.panel);
    if (shape == nullptr) return;
    SnapOptions options = snap_options(context, pointer.modifiers);
    options.to_guides = false;
    const int from = pressed_.control == 0 ? curve_.start : curve_.end;
    options.origin = shape->on_sheet(shape->panel.vertices.at(static_cast<std::size_t>(from)));
    snapped_ = snap(context.geometry, pointer.at, options);
    OutlineEdge curve = curve_;
    curve.control.at(static_cast<std::size_t>(pressed_.control)) = shape->in_panel(snapped_.point);
    context.document.attempt(SetCurve{pressed_.panel, pressed_.index, curve});
}

void EditPointTool::drag_line_point(ToolContext& context, const SheetPointer& pointer) {
    const PanelShape* shape = context.geometry.find(pressed_.panel);
    if (shape == nullptr) return;
    snapped_ = snap(context.geometry, pointer.at, snap_options(context, pointer.modifiers));
    InternalLine line = line_;
    line.points.at(line_point_) = shape->in_panel(snapped_.point);
    context.document.attempt(SetInternalLine{pressed_.panel, pressed_.index, line});
}

void EditPointTool::drop(ToolContext& context, const SheetPointer& pointer) {
    if (!is_dragging_part_) return SelectTool::drop(context, pointer);
    is_dragging_part_ = false;
    context.document.keep();
}

void EditPointTool::double_click(ToolContext& context, const SheetPointer& pointer) {
    PickOptions options = pick_options(context);
    const Pick picked = pick(context.geometry, pointer.at, options);
    if (picked.kind != PickKind::Edge) return;
    const double t =
        snap_along(*context.geometry.edge(picked.ref()), picked.t, snap_options(context, pointer.modifiers));
    context.document.run(AddVertex{picked.panel, picked.index, t});
}

bool EditPointTool::cancel(ToolContext& context) {
    const bool was_dragging = is_dragging_part_;
    is_dragging_part_ = false;
    return SelectTool::cancel(context) || was_dragging;
}

void EditPointTool::draw(const ToolContext& context, ToolOverlay& overlay) const {
    overlay.shows_vertices = true;
    overlay.handle_edges = shown_handles(context);
    SelectTool::draw(context, overlay);
    if (!is_dragging_part_) return;
    add_guides(overlay, snapped_);
    if (pressed_.kind != PickKind::Handle) return;
    if (const EdgeShape* edge = context.geometry.edge(pressed_.ref())) overlay.readout = {in_cm(edge->length)};
}

std::string EditPointTool::hint(const ToolContext&) const {
    return "Drag points and handles; double click an edge to add a point, Delete to take one out";
}

}  // namespace selvedge
