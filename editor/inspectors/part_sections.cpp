// Points, edges, notches and internal lines of panels.
#include <imgui.h>

#include <algorithm>
#include <array>

#include "editor/drafting/sheet_layout.h"
#include "editor/inspectors/controls.h"
#include "editor/inspectors/number_box.h"
#include "editor/inspectors/pattern_figures.h"
#include "editor/inspectors/property_sections.h"
#include "editor/inspectors/vector_row.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/seam_name.h"

namespace selvedge {
namespace {

constexpr double kShortestEdge = 0.001;  // m, that can be typed

struct FoundPanel {
    const Panel& panel;
    int index = 0;
    Vec2d origin = Vec2d::Zero();  // m, on the sheet
};

std::optional<FoundPanel> find(const Pattern& pattern, const std::string& name) {
    const std::optional<int> index = panel_index(pattern, name);
    if (!index) return std::nullopt;
    const auto at = static_cast<std::size_t>(*index);
    return FoundPanel{.panel = pattern.panels[at], .index = *index, .origin = sheet_positions(pattern)[at]};
}

void draw_pin(InspectorContext& context, const PartRef& vertex) {
    const std::optional<FoundPanel> found = find(context.pattern(), vertex.panel);
    if (!found) return;
    std::vector<int> pins = found->panel.pins;
    const auto pin = std::find(pins.begin(), pins.end(), vertex.index);
    const bool is_pinned = pin != pins.end();
    if (!check_box(context, "vertex.pin", "Pinned", is_pinned, "Stays where it is placed while the cloth falls."))
        return;
    if (is_pinned) {
        pins.erase(pin);
    } else {
        pins.push_back(vertex.index);
    }
    context.workspace.run(SetPins{.panel = vertex.panel, .vertices = pins});
}

void draw_vertex(InspectorContext& context, const PartRef& vertex) {
    const std::optional<FoundPanel> found = find(context.pattern(), vertex.panel);
    if (!found) return;
    const Vec2d at = found->panel.vertices[static_cast<std::size_t>(vertex.index)] + found->origin;
    const VectorEdit moved = vector_row(
        context, {.name = "vertex.place", .label = "On the sheet", .tip = "Where the point lies, as the rulers show."},
        at);
    if (!moved) return;
    Vec2d by = Vec2d::Zero();
    by[moved.axis] = moved.number.by();
    carry(context, moved.number, MoveVertices{.vertices = {vertex}, .by = by});
}

void draw_kind(InspectorContext& context, const PartRef& edge, const FoundPanel& found, const OutlineEdge& curve) {
    const std::array<std::string, 4> kinds{"Line", "Curve, one handle", "Curve, two handles", "Circle arc"};
    const auto kind = static_cast<int>(curve.kind);
    row_label(context, "Kind", "How the edge runs from its start to its end.");
    const int chosen = choice_box(context, {.name = "edge.kind",
                                            .shown = kinds[static_cast<std::size_t>(kind)],
                                            .items = kinds,
                                            .chosen = kind,
                                            .tip = "Another kind keeps the shape as nearly as it can.",
                                            .width_px = field_width()});
    if (chosen < 0 || chosen == kind) return;
    context.workspace.run(SetCurve{.panel = edge.panel,
                                   .edge = edge.index,
                                   .curve = with_kind(found.panel, curve, static_cast<CurveKind>(chosen))});
}

void draw_controls(InspectorContext& context, const PartRef& edge, const FoundPanel& found, const OutlineEdge& curve) {
    const std::size_t count = curve.kind == CurveKind::Quadratic ? 1 : curve.kind == CurveKind::Cubic ? 2 : 0;
    constexpr std::array<const char*, 2> kNames{"edge.handle1", "edge.handle2"};
    for (std::size_t i = 0; i < count; ++i) {
        const char* label = count == 1 ? "Handle" : i == 0 ? "First handle" : "Second handle";
        const VectorEdit moved = vector_row(
            context, {.name = kNames[i], .label = label, .tip = "Where the curve's handle lies on the sheet."},
            Vec2d(curve.control[i] + found.origin));
        if (!moved) continue;
        SetCurve command{.panel = edge.panel, .edge = edge.index, .curve = curve};
        command.curve.control[i][moved.axis] = moved.number.value.value_or(0) - found.origin[moved.axis];
        return carry(context, moved.number, command);
    }
}

void draw_arc(InspectorContext& context, const PartRef& edge, const FoundPanel& found, const OutlineEdge& curve) {
    SetCurve command{.panel = edge.panel, .edge = edge.index, .curve = curve};
    const NumberEdit radius = number_row(context,
                                         {.name = "edge.radius",
                                          .value = curve.arc_radius,
                                          .tip = "Of the circle; half the distance of the ends or more.",
                                          .least = least_arc_radius(found.panel, curve)},
                                         "Radius");
    if (radius) {
        command.curve.arc_radius = radius.value.value_or(curve.arc_radius);
        return carry(context, radius, command);
    }
    if (check_box(context, "edge.large", "Longer way round", curve.is_large_arc,
                  "The part of the circle that is more than half of it.")) {
        command.curve.is_large_arc = !curve.is_large_arc;
        context.workspace.run(command);
    } else if (check_box(context, "edge.inward", "Hollow", curve.turns_right,
                         "Bends into the panel, where it else bulges out.")) {
        command.curve.turns_right = !curve.turns_right;
        context.workspace.run(command);
    }
}

void draw_length(InspectorContext& context, const PartRef& edge, const FoundPanel& found, const OutlineEdge& curve) {
    const NumberEdit length = number_row(context,
                                         {.name = "edge.length",
                                          .value = outline_length(found.panel, curve),
                                          .tip = "Type a length: the end of the edge moves, its start stays.",
                                          .least = kShortestEdge},
                                         "Length");
    if (!length) return;
    const double before = length.before.value_or(0);
    const Vec2d by = shift_for_length(found.panel, curve, {.before = before, .after = length.value.value_or(before)});
    carry(context, length, MoveVertices{.vertices = {{edge.panel, curve.end}}, .by = by});
}

void draw_seam_of(InspectorContext& context, const FoundPanel& found, int edge) {
    const std::optional<int> seam = seam_along(context.pattern(), {.panel = found.index, .edge = edge});
    if (!seam) {
        fact(context, "Seam", "not sewn", "No seam runs along this edge.");
        return;
    }
    const Seam& sewn = context.pattern().seams[static_cast<std::size_t>(*seam)];
    fact(context, "Seam", seam_name(context.pattern(), sewn), "The seam along this edge.");
    ButtonRow row(context);
    if (row.button({.name = "edge.seam", .title = "Select seam", .tip = "Shows the seam along this edge."})) {
        Selection selected;
        selected.seams.insert(*seam);
        context.workspace.document->select(selected);
    }
}

}  // namespace

void draw_vertices_section(InspectorContext& context) {
    const std::set<PartRef> vertices = context.selection().vertices;
    if (vertices.empty()) return;
    const PartRef first = *vertices.begin();
    const bool is_one = vertices.size() == 1;
    heading(context, is_one ? ("Point " + std::to_string(first.index) + " of " + first.panel).c_str()
                            : (std::to_string(vertices.size()) + " points").c_str());
    ImGui::PushID(is_one ? (first.panel + "." + std::to_string(first.index)).c_str() : "points");
    if (is_one) draw_vertex(context, first);
    const VectorEdit moved =
        vector_row(context, {.name = "vertex.move", .label = "Move by", .tip = "From where it is now."}, Vec2d(0, 0));
    if (moved) {
        carry(context, moved.number,
              MoveVertices{.vertices = {vertices.begin(), vertices.end()}, .by = edited(Vec2d(0, 0), moved)});
    }
    if (is_one && context.selection().vertices.contains(first)) draw_pin(context, first);
    ImGui::PopID();
}

void draw_edge_section(InspectorContext& context, const PartRef& edge) {
    const auto found = find(context.pattern(), edge.panel);
    if (!found || static_cast<std::size_t>(edge.index) >= found->panel.edges.size()) return;
    heading(context, ("Edge " + std::to_string(edge.index) + " of " + edge.panel).c_str());
    ImGui::PushID(("edge " + edge.panel + "." + std::to_string(edge.index)).c_str());
    // Copies: what a box changes is seen by the next ones a frame later.
    const Panel panel = found->panel;
    const FoundPanel shown{.panel = panel, .index = found->index, .origin = found->origin};
    const OutlineEdge curve = panel.edges[static_cast<std::size_t>(edge.index)];
    draw_length(context, edge, shown, curve);
    draw_kind(context, edge, shown, curve);
    draw_controls(context, edge, shown, curve);
    if (curve.kind == CurveKind::Arc) draw_arc(context, edge, shown, curve);
    draw_seam_of(context, shown, edge.index);
    ImGui::PopID();
}

void draw_notch_section(InspectorContext& context, const PartRef& notch) {
    const auto found = find(context.pattern(), notch.panel);
    if (!found || static_cast<std::size_t>(notch.index) >= found->panel.notches.size()) return;
    const Notch held = found->panel.notches[static_cast<std::size_t>(notch.index)];
    const double length = outline_length(found->panel, found->panel.edges[static_cast<std::size_t>(held.edge)]);
    heading(context, ("Notch of " + notch.panel).c_str());
    ImGui::PushID(("notch " + notch.panel + "." + std::to_string(notch.index)).c_str());
    const NumberEdit from_start = number_row(context,
                                             {.name = "notch.from_start",
                                              .value = held.t * length,
                                              .tip = "Along the edge, from its start.",
                                              .least = 0,
                                              .most = length},
                                             "From start");
    const NumberEdit from_end = number_row(context,
                                           {.name = "notch.from_end",
                                            .value = (1 - held.t) * length,
                                            .tip = "Along the edge, from its end.",
                                            .least = 0,
                                            .most = length},
                                           "From end");
    MoveNotch command{.panel = notch.panel, .index = notch.index, .edge = held.edge};
    if (from_start) {
        command.t = std::clamp(from_start.value.value_or(0) / length, 0.0, 1.0);
        carry(context, from_start, command);
    } else if (from_end) {
        command.t = std::clamp(1 - from_end.value.value_or(0) / length, 0.0, 1.0);
        carry(context, from_end, command);
    }
    fact(context, "On edge", std::to_string(held.edge), "The edge of the outline that it marks.");
    ButtonRow row(context);
    if (row.button({.name = "notch.delete", .title = "Delete", .tip = "Removes the notch (Del)."})) {
        context.workspace.run(RemoveParts{.notches = {notch}});
    }
    ImGui::PopID();
}

void draw_internal_line_section(InspectorContext& context, const PartRef& line) {
    const auto found = find(context.pattern(), line.panel);
    if (!found || static_cast<std::size_t>(line.index) >= found->panel.internal_lines.size()) return;
    const InternalLine held = found->panel.internal_lines[static_cast<std::size_t>(line.index)];
    double length = 0;
    for (std::size_t i = 1; i < held.points.size(); ++i) length += (held.points[i] - held.points[i - 1]).norm();
    heading(context, ("Internal line of " + line.panel).c_str());
    ImGui::PushID(("line " + line.panel + "." + std::to_string(line.index)).c_str());
    row_label(context, "Name", "What the line is called.");
    const auto name = text_box(context, {.name = "line.name",
                                         .text = held.name,
                                         .hint = "unnamed",
                                         .tip = "What the line is called.",
                                         .width_px = field_width()});
    if (name) {
        context.workspace.run(SetInternalLine{.panel = line.panel, .index = line.index, .line = {*name, held.points}});
    }
    fact(context, "Length", quantity_text(length, Unit::Centimetres), "From its first point to its last.");
    fact(context, "Points", std::to_string(held.points.size()), "That the line goes through.");
    ButtonRow row(context);
    if (row.button({.name = "line.delete", .title = "Delete", .tip = "Removes the line (Del)."})) {
        context.workspace.run(RemoveParts{.internal_lines = {line}});
    }
    ImGui::PopID();
}

}  // namespace selvedge
