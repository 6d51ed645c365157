#include "editor/tools/outline_tools.h"

#include <algorithm>
#include <cmath>

#include "editor/geometry/draft.h"
#include "editor/geometry/outline_edit.h"
#include "editor/geometry/panel_edit.h"
#include "editor/tools/select_tool.h"
#include "editor/tools/tool.h"
#include "sim/pattern/outline.h"

namespace selvedge::editor {
namespace {

PickOptions edges_only(const ToolContext& context) {
    PickOptions options = pick_options(context);
    options.tolerance *= 1.6;  // larger, because only edges are candidates
    options.vertices = options.notches = options.internal_lines = options.panels = false;
    return options;
}

}  // namespace

EdgePoint at_length(const SheetGeometry& geometry, const EdgePoint& place, double length) {
    const EdgeShape* edge = geometry.edge(place.edge);
    if (edge == nullptr || !(edge->length > 0)) return place;
    const double share = length / edge->length;
    if (!(share > 0 && share < 1)) throw GeometryError("The edge is only " + in_cm(edge->length) + " long");
    return {place.edge, place.t <= 0.5 ? share : 1 - share};
}

std::optional<EdgePoint> edge_point_at(const ToolContext& context, const SheetPointer& pointer) {
    const Pick picked = pick(context.geometry, pointer.at, edges_only(context));
    if (picked.kind != PickKind::Edge) return {};
    const EdgeShape& edge = *context.geometry.edge(picked.ref());
    return EdgePoint{picked.ref(), snap_along(edge, picked.t, snap_options(context, pointer.modifiers))};
}

GeometryError no_edge_error(const ToolContext& context, const SheetPointer& pointer, const std::string& use) {
    const std::string only = "only edges of outlines are " + use;
    for (const PanelShape& shape : context.geometry.panels()) {
        const bool is_locked = !shape.is_hidden && !shape.may_be_picked;
        if (is_locked && shape.contains(shape.in_panel(pointer.at)))
            return GeometryError("'" + shape.panel.name + "' is locked: unlock it first (Panel > Unlock all)",
                                 {{.panel = shape.panel.name}});
    }
    const Pick picked = pick(context.geometry, pointer.at, pick_options(context));
    if (picked.kind == PickKind::InternalLine)
        return GeometryError("This is an internal line: " + only + ". Cut the panel along it (U) to make it an edge",
                             {{.panel = picked.panel}});
    if (picked.kind == PickKind::Panel)
        return GeometryError("This is the inside of '" + picked.panel + "': " + only + ". Click one of them",
                             {{.panel = picked.panel}});
    return GeometryError("There is no edge here: " + only);
}

void EdgeTool::require_place(const ToolContext& context, const SheetPointer& pointer, const std::string& use) const {
    if (!place_) throw no_edge_error(context, pointer, use);
}

void EdgeTool::hover(ToolContext& context, const SheetPointer& pointer) {
    Tool::hover(context, pointer);
    place_ = edge_point_at(context, pointer);
    if (!place_) return;
    context.hover =
        hover_of(context.geometry, {.kind = PickKind::Edge, .panel = place_->edge.panel, .index = place_->edge.index});
}

void EdgeTool::draw(const ToolContext& context, ToolOverlay& overlay) const {
    if (!place_) return;
    const PanelShape* shape = context.geometry.find(place_->edge.panel);
    const EdgeShape* edge = context.geometry.edge(place_->edge);
    if (shape == nullptr || edge == nullptr) return;
    EdgePoint place = *place_;
    const bool is_typed = context.typed && context.typed->size() == 1 && context.typed->front() > 0 &&
                          context.typed->front() / 100 < edge->length;
    if (is_typed) place = at_length(context.geometry, place, context.typed->front() / 100);
    overlay.handles.push_back(
        {sheet_point(*shape, place.edge.index, place.t), HandleShape::Round, OverlayTone::Draft, true});
    overlay.readout = {in_cm(place.t * edge->length) + " | " + in_cm((1 - place.t) * edge->length),
                       "of " + in_cm(edge->length)};
}

// --- add point

void AddPointTool::click(ToolContext& context, const SheetPointer& pointer) {
    require_place(context, pointer, "given points");
    context.document.run(AddVertex{place_->edge.panel, place_->edge.index, place_->t});
}

bool AddPointTool::enter(ToolContext& context, const std::vector<double>& numbers) {
    if (!place_ || numbers.size() != 1) return false;
    const EdgePoint place = at_length(context.geometry, *place_, numbers[0] / 100);
    context.document.run(AddVertex{place.edge.panel, place.edge.index, place.t});
    return true;
}

std::string AddPointTool::hint(const ToolContext&) const {
    return "Click an edge, or point at it and type how far from its nearer end (cm), then Enter";
}

// --- notch

void NotchTool::press(ToolContext& context, const SheetPointer& pointer) {
    PickOptions options = pick_options(context);
    options.vertices = options.edges = options.internal_lines = options.panels = false;
    const Pick picked = pick(context.geometry, pointer.at, options);
    held_.reset();
    if (picked.kind == PickKind::Notch) held_ = picked.ref();
}

void NotchTool::click(ToolContext& context, const SheetPointer& pointer) {
    if (held_) {
        Selection selection;
        selection.notches.insert(*held_);
        context.document.select(selection);
    } else {
        require_place(context, pointer, "notched");
        context.document.run(AddNotch{place_->edge.panel, place_->edge.index, place_->t});
    }
    held_.reset();
}

void NotchTool::drag(ToolContext& context, const SheetPointer& pointer) {
    if (!held_) return;
    const std::optional<EdgePoint> to = edge_point_at(context, pointer);
    if (!to || to->edge.panel != held_->panel) return;
    place_ = to;
    context.document.preview(MoveNotch{held_->panel, held_->index, to->edge.index, to->t});
}

void NotchTool::drop(ToolContext& context, const SheetPointer& pointer) {
    if (!held_) return click(context, pointer);
    held_.reset();
    context.document.commit();
}

bool NotchTool::enter(ToolContext& context, const std::vector<double>& numbers) {
    if (!place_ || numbers.size() != 1) return false;
    const EdgePoint place = at_length(context.geometry, *place_, numbers[0] / 100);
    context.document.run(AddNotch{place.edge.panel, place.edge.index, place.t});
    return true;
}

std::string NotchTool::hint(const ToolContext&) const {
    return "Click an edge to notch it, drag a notch to move it; type how far from the nearer end (cm)";
}

// --- dart

std::vector<Vec2d> dart_lines(const PanelShape& shape, const EdgePoint& place, double width, double depth) {
    const EdgeShape& edge = shape.edges.at(static_cast<std::size_t>(place.edge.index));
    const double half = edge.length > 0 ? width / 2 / edge.length : 0;
    const Vec2d tangent = edge.tangent(place.t);
    const Vec2d tip = edge.at(place.t) + depth * Vec2d(-tangent.y(), tangent.x());
    return {shape.on_sheet(edge.at(place.t - half)), shape.on_sheet(tip), shape.on_sheet(edge.at(place.t + half))};
}

namespace {

// Why the dart cannot be there; empty: it can.
std::string why_no_dart(const sim::Pattern& pattern, const EdgePoint& place, double width, double depth) {
    const std::optional<int> panel = panel_index(pattern, place.edge.panel);
    if (!panel) return "";
    sim::Pattern tried = pattern;
    try {
        insert_dart(tried, {.panel = *panel, .edge = place.edge.index}, place.t, width, depth);
        return "";
    } catch (const GeometryError& error) {
        return error.what();
    }
}

}  // namespace

void DartTool::press(ToolContext&, const SheetPointer&) {
    mouth_ = place_;
}

// Keeps mouth_: typed numbers may follow.
void DartTool::click(ToolContext& context, const SheetPointer& pointer) {
    require_place(context, pointer, "given darts");
}

void DartTool::drag(ToolContext& context, const SheetPointer& pointer) {
    if (!mouth_) return;
    const PanelShape* shape = context.geometry.find(mouth_->edge.panel);
    if (shape == nullptr) return;
    const EdgeShape& edge = shape->edges.at(static_cast<std::size_t>(mouth_->edge.index));
    const Vec2d tangent = edge.tangent(mouth_->t);
    const double inward = sim::cross2(tangent, shape->in_panel(pointer.at) - edge.at(mouth_->t));
    constexpr double kStep = 0.005;  // m
    const bool is_snapping = snap_options(context, pointer.modifiers).is_on;
    depth_ = std::max(kStep, is_snapping ? std::round(inward / kStep) * kStep : inward);
}

void DartTool::drop(ToolContext& context, const SheetPointer&) {
    if (mouth_) make(context);
}

bool DartTool::enter(ToolContext& context, const std::vector<double>& numbers) {
    if (!mouth_) mouth_ = place_;
    if (!mouth_ || numbers.size() > 2) return false;
    if (numbers.size() == 2) width_ = numbers[0] / 100;
    depth_ = numbers.back() / 100;
    make(context);
    return true;
}

void DartTool::make(ToolContext& context) {
    const EdgePoint mouth = *mouth_;
    mouth_.reset();
    context.document.run(AddDart{mouth.edge.panel, mouth.edge.index, mouth.t, width_, depth_});
}

bool DartTool::cancel(ToolContext&) {
    const bool had_mouth = mouth_.has_value();
    mouth_.reset();
    return had_mouth;
}

void DartTool::draw(const ToolContext& context, ToolOverlay& overlay) const {
    EdgeTool::draw(context, overlay);
    const std::optional<EdgePoint>& place = mouth_ ? mouth_ : place_;
    if (!place) return;
    const PanelShape* shape = context.geometry.find(place->edge.panel);
    if (shape == nullptr || context.geometry.edge(place->edge) == nullptr) return;
    double width = width_, depth = depth_;
    if (context.typed && context.typed->size() <= 2) {
        if (context.typed->size() == 2) width = context.typed->front() / 100;
        depth = context.typed->back() / 100;
    }
    overlay.problem = why_no_dart(context.document.pattern(), *place, width, depth);
    const OverlayTone tone = mouth_ ? OverlayTone::Draft : OverlayTone::Faint;
    overlay.lines.push_back({.points = dart_lines(*shape, *place, width, depth),
                             .tone = overlay.problem.empty() ? tone : OverlayTone::Warning,
                             .is_dashed = !overlay.problem.empty()});
    overlay.readout.push_back(in_cm(width) + " wide, " + in_cm(depth) + " deep");
}

std::string DartTool::hint(const ToolContext&) const {
    return "Drag from an edge inward, or click it and type width x depth (cm), then Enter";
}

PickOptions CurveTool::wanted(const ToolContext& context) const {
    PickOptions options = pick_options(context);
    options.vertices = options.notches = options.internal_lines = false;
    std::set<std::string> panels = touched_panels(context.document.changeable());
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
    sim::OutlineEdge curve = before_.edges.at(static_cast<std::size_t>(pressed_.index));
    if (pressed_.kind == PickKind::Handle) {
        curve.control.at(static_cast<std::size_t>(pressed_.control)) = to;
    } else if (pointer.modifiers.alt) {
        curve = arc_through(before_, curve, to);
    } else {
        if (curve.kind == sim::CurveKind::Arc && pointer.modifiers.shift) curve.kind = sim::CurveKind::Line;
        if (pointer.modifiers.shift) curve = as_cubic_edge(before_, curve);
        curve = bent_through(before_, curve, pressed_.t, to);
    }
    context.document.preview(SetCurve{pressed_.panel, pressed_.index, curve});
}

void CurveTool::drop(ToolContext& context, const SheetPointer&) {
    is_dragging_ = false;
    context.document.commit();
}

// Makes the edge a line again.
void CurveTool::double_click(ToolContext& context, const SheetPointer& pointer) {
    const Pick picked = pick(context.geometry, pointer.at, wanted(context));
    if (picked.kind == PickKind::Edge) context.document.run(SetCurve{picked.panel, picked.index, sim::OutlineEdge{}});
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
    const sim::OutlineEdge& curve = shape->panel.edges.at(static_cast<std::size_t>(pressed_.index));
    overlay.readout = {in_cm(edge->length)};
    if (curve.kind == sim::CurveKind::Arc) overlay.readout.push_back("radius " + in_cm(curve.arc_radius));
}

std::string CurveTool::hint(const ToolContext&) const {
    return "Drag an edge to bend it; Shift: with two handles, Alt: a circle's arc; double click: straight";
}

namespace {

struct Ends {
    Vec2d start;
    Vec2d end;
};

Ends ends_of(const sim::Panel& panel, const sim::OutlineEdge& edge) {
    return {panel.vertices.at(static_cast<std::size_t>(edge.start)),
            panel.vertices.at(static_cast<std::size_t>(edge.end))};
}

// The curve parameter at the fraction t of the edge's length, by a search with halved steps.
double parameter_at(const sim::Panel& panel, const sim::OutlineEdge& edge, double t) {
    if (edge.kind == sim::CurveKind::Line) return t;
    const Vec2d wanted = outline_point(panel, edge, t);
    double best = t, distance = (curve_point(panel, edge, t) - wanted).norm();
    for (double step = 0.25; step > 1e-4; step /= 2) {
        for (const double s : {best - step, best + step}) {
            const double away = (curve_point(panel, edge, std::clamp(s, 0.0, 1.0)) - wanted).norm();
            if (away < distance) {
                distance = away;
                best = std::clamp(s, 0.0, 1.0);
            }
        }
    }
    return best;
}

}  // namespace

sim::OutlineEdge bent_through(const sim::Panel& panel, const sim::OutlineEdge& edge, double t, const Vec2d& to) {
    if (edge.kind == sim::CurveKind::Arc) return arc_through(panel, edge, to);
    const auto [start, end] = ends_of(panel, edge);
    const double s = std::clamp(parameter_at(panel, edge, t), 0.1, 0.9);
    const double r = 1 - s;
    sim::OutlineEdge bent = edge;
    if (edge.kind == sim::CurveKind::Cubic) {
        const Vec2d by = (to - curve_point(panel, edge, s)) / (3 * r * s);
        bent.control[0] += by;
        bent.control[1] += by;
        return bent;
    }
    bent.kind = sim::CurveKind::Quadratic;
    bent.control[0] = (to - r * r * start - s * s * end) / (2 * r * s);
    return bent;
}

sim::OutlineEdge arc_through(const sim::Panel& panel, const sim::OutlineEdge& edge, const Vec2d& to) {
    const auto [start, end] = ends_of(panel, edge);
    const Vec2d chord = end - start, a = to - start, b = to - end;
    const double twice_area = sim::cross2(chord, a);  // positive: the point is left of the chord
    sim::OutlineEdge arc = edge;
    arc.control = {Vec2d::Zero(), Vec2d::Zero()};
    if (std::abs(twice_area) <= 1e-4 * chord.squaredNorm()) {
        arc.kind = sim::CurveKind::Line;
        arc.arc_radius = 0;
        return arc;
    }
    arc.kind = sim::CurveKind::Arc;
    arc.arc_radius = a.norm() * b.norm() * chord.norm() / (2 * std::abs(twice_area));
    arc.turns_right = twice_area > 0;
    arc.is_large_arc = a.dot(b) > 0;  // the angle at `to` is less than a right angle
    return arc;
}

sim::OutlineEdge as_cubic_edge(const sim::Panel& panel, const sim::OutlineEdge& edge) {
    const auto [start, end] = ends_of(panel, edge);
    sim::OutlineEdge cubic = edge;
    if (edge.kind == sim::CurveKind::Cubic) return cubic;
    cubic.kind = sim::CurveKind::Cubic;
    if (edge.kind == sim::CurveKind::Quadratic) {
        cubic.control = {start + 2.0 / 3 * (edge.control[0] - start), end + 2.0 / 3 * (edge.control[0] - end)};
    } else {
        cubic.control = {start + (end - start) / 3, end - (end - start) / 3};
    }
    return cubic;
}

}  // namespace selvedge::editor
