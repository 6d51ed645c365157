// The panel section: a panel's name, size, placement and cloth.
#include "editor/inspectors/property_inspector.h"

#include <imgui.h>
#include <algorithm>
#include <array>

#include "editor/geometry/draft.h"
#include "editor/geometry/outline_edit.h"
#include "editor/geometry/panel_edit.h"
#include "editor/geometry/sewing.h"
#include "editor/inspectors/controls.h"
#include "editor/inspectors/field_rows.h"
#include "editor/inspectors/material_inspector.h"
#include "editor/inspectors/number_box.h"
#include "editor/inspectors/pattern_measures.h"
#include "sim/core/printable.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/garments.h"
#include "sim/pattern/halves.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/pattern.h"
#include "sim/pattern/sources.h"

namespace selvedge::editor {
namespace {

constexpr double kChordError = 0.0005;  // m, for outlines of which only the bounding box is used
constexpr double kMinScale = 0.01;
constexpr double kMinSize = 0.001;  // m

// A panel and its position on the sheet.
struct PanelOnSheet {
    const sim::Panel& panel;
    Vec2d origin = Vec2d::Zero();  // m
};

std::string area_text(double area) {
    return area < 0.1 ? quantity_number(area * 1e4, Unit::Whole) + " cm\u00B2"
                      : quantity_number(area, Unit::Plain) + " m\u00B2";
}

const PanelMeasures& facts_of(InspectorContext& context, const sim::Panel& panel) {
    PanelMeasures& facts = context.state.panels[panel.name];
    const std::uint64_t revision = context.workspace.document->revision() + 1;  // 0: not computed yet
    if (facts.revision != revision) {
        facts = {.revision = revision, .area = outline_area(panel), .perimeter = panel_perimeter(panel)};
    }
    return facts;
}

TransformPanels scaling(const std::vector<std::string>& panels, const Vec2d& centre, int axis, double factor) {
    Vec2d factors(1, 1);
    factors[axis] = factor;
    return {.panels = panels, .map = scale_about(centre, factors), .what = "Scale"};
}

sim::Pattern only_selected(const sim::Pattern& pattern, const Selection& selected) {
    sim::Pattern part;
    for (const sim::Panel& panel : pattern.panels) {
        if (selected.panels.contains(panel.name)) part.panels.push_back(panel);
    }
    return part;
}

// Shifts the panels from where they are shown now, which may be a preview.
PlacePanels placing(const sim::Pattern& pattern, const Selection& selected, const Vec3d& by) {
    PlacePanels command;
    for (const sim::Panel& panel : pattern.panels) {
        if (!selected.panels.contains(panel.name)) continue;
        command.places.push_back({.panel = panel.name,
                                  .translation = panel.translation + by,
                                  .rotation = panel.rotation,
                                  .wrap_radius = panel.wrap_radius});
    }
    return command;
}

void draw_name(InspectorContext& context, const sim::Panel& panel) {
    row_label(context, "Name", "What the panel is called.");
    const auto name = text_box(context, {.name = "panel.name",
                                         .text = panel.name,
                                         .tip = "What the panel is called. No two have the same name.",
                                         .width_px = field_width(),
                                         .wrong = [](const std::string& text) -> std::string {
                                             return text.empty() ? "A panel has a name" : "";
                                         }});
    if (name) context.workspace.run(RenamePanel{.panel = panel.name, .to = *name});
}

// Scales the panel (S XY): by a factor relative to its current size, or by the resulting size.
void draw_scale(InspectorContext& context, const PanelOnSheet& shown) {
    const std::vector<std::string> panels{shown.panel.name};
    const Eigen::AlignedBox2d box = outline_box(shown.panel, kChordError);
    const Vec2d centre = box.center() + shown.origin;
    const VectorEdit scale = vector_row(context,
                                        {.name = "panel.scale",
                                         .label = "Scale",
                                         .unit = Unit::Factor,
                                         .tip = "Scales the outline about its middle: 1.05 or 105%.",
                                         .least = kMinScale},
                                        Vec2d(1, 1));
    if (scale) apply_edit(context, scale.number, scaling(panels, centre, scale.axis, scale.number.value.value_or(1)));
    const VectorEdit size = vector_row(context,
                                       {.name = "panel.size",
                                        .label = "Size",
                                        .tip = "Of the box about its outline; type one to scale the panel to it.",
                                        .axes = {"W", "H", ""},
                                        .least = kMinSize},
                                       Vec2d(box.sizes()));
    if (size && size.number.before.value_or(0) > 0) {
        const double factor = size.number.value.value_or(0) / *size.number.before;
        apply_edit(context, size.number, scaling(panels, centre, size.axis, factor));
    }
}

// The angles as typed, as long as they still give the panel's rotation.
Vec3d shown_angles(const InspectorContext& context, const sim::Panel& panel) {
    const auto typed = context.state.angles.find(panel.name);
    constexpr double kSame = 1e-9;
    if (typed != context.state.angles.end() && typed->second.rotation.isApprox(panel.rotation, kSame)) {
        return typed->second.angles;
    }
    return angles_of(panel.rotation);
}

void draw_place(InspectorContext& context, const sim::Panel& panel) {
    PlacePanel placed{.panel = panel.name,
                      .translation = panel.translation,
                      .rotation = panel.rotation,
                      .wrap_radius = panel.wrap_radius};
    const VectorEdit moved =
        vector_row(context,
                   {.name = "panel.translation",
                    .label = "Place",
                    .tip = "Where the panel's origin stands in the room: X to the body's left, Y up, Z to the front."},
                   panel.translation);
    const Vec3d angles = shown_angles(context, panel);
    const VectorEdit turned = vector_row(context,
                                         {.name = "panel.rotation",
                                          .label = "Turn",
                                          .unit = Unit::Degrees,
                                          .tip = "Turned about X first, then Y, then Z, as the room has them."},
                                         angles);
    const NumberEdit wrapped = number_row(context,
                                          {.name = "panel.wrap_radius",
                                           .value = panel.wrap_radius,
                                           .tip = "Bends the panel round an upright behind it, to lie about the "
                                                  "body. 0: flat.",
                                           .least = 0},
                                          "Wrap radius");
    if (moved) {
        placed.translation = edited(panel.translation, moved);
        apply_edit(context, moved.number, placed);
    } else if (turned) {
        const Vec3d wanted = edited(angles, turned);
        placed.rotation = rotation_of(wanted);
        const std::string name = panel.name;
        apply_edit(context, turned.number, placed);
        context.state.angles[name] = {.angles = wanted, .rotation = rotation_of(wanted)};
    } else if (wrapped) {
        placed.wrap_radius = wrapped.value.value_or(0);
        apply_edit(context, wrapped, placed);
    }
}

void draw_cloth(InspectorContext& context, const sim::Panel& panel) {
    fabric_row(context, panel.name);
    sim::Panel standing;
    standing.allowance = context.pattern().allowance;
    field_rows(context, {.part = FieldOwner::Panel, .panel = panel.name}, panel, standing);
}

void draw_links(InspectorContext& context, const sim::Panel& panel) {
    const std::string name = panel.name;
    const std::optional<sim::Link> link = sim::link_with(context.pattern(), panel);
    if (!panel.pins.empty()) {
        fact(context, "Pins", sim::count_text(panel.pins.size(), "point"),
             "Points of the outline that stay where they are placed.");
    }
    if (link)
        fact(context, link->kind == sim::Derivation::Mirror ? "Mirror of" : "Copy of", link->source,
             "Both are kept alike: what is done to one is done to both.");
    const bool has_halves = sim::has_linked_halves(panel);
    if (has_halves) fact(context, "Halves", "linked", "They are mirror images: what is done to one is done to both.");
    ButtonRow row(context);
    const bool has_pins = !panel.pins.empty();
    const bool is_linked = link || has_halves;
    if (is_linked && row.button({.name = "panel.unlink",
                                 .title = "Unlink",
                                 .tip = with_key(context, "Both go their own ways", "panel.unlink")})) {
        context.workspace.run(UnlinkPanel{name});
    } else if (has_pins && row.button({.name = "panel.unpin", .title = "Unpin", .tip = "No point of it is held."})) {
        context.workspace.run(SetPins{.panel = name});
    }
}

}  // namespace

void draw_panel_section(InspectorContext& context, const std::string& name) {
    const std::optional<int> index = panel_index(context.pattern(), name);
    if (!index) return;
    const auto at = static_cast<std::size_t>(*index);
    const sim::Panel panel = context.pattern().panels[at];  // a copy: a field may change the pattern
    const PanelMeasures facts = facts_of(context, panel);
    const Vec2d origin = sheet_positions(context.pattern())[at];
    heading(context, ("Panel " + name).c_str());
    ImGui::PushID(name.c_str());
    draw_name(context, panel);
    draw_scale(context, {.panel = panel, .origin = origin});
    draw_place(context, panel);
    draw_cloth(context, panel);
    fact(context, "Area", area_text(facts.area), "Of the cloth inside the outline.");
    fact(context, "Perimeter", quantity_text(facts.perimeter, Unit::Centimetres), "The length of the outline.");
    fact(context, "Points", std::to_string(panel.vertices.size()), "Corners and joints of the outline.");
    draw_links(context, panel);
    ImGui::PopID();
}

void draw_panels_section(InspectorContext& context) {
    const Selection selected = context.selection();
    const sim::Pattern& pattern = context.pattern();
    const std::vector<Vec2d> origins = sheet_positions(pattern);
    Eigen::AlignedBox2d all;
    double area = 0;
    for (std::size_t i = 0; i < pattern.panels.size(); ++i) {
        if (!selected.panels.contains(pattern.panels[i].name)) continue;
        all.extend(outline_box(pattern.panels[i], kChordError).translated(origins[i]));
        area += facts_of(context, pattern.panels[i]).area;
    }
    if (all.isEmpty()) return;
    heading(context, (std::to_string(selected.panels.size()) + " panels").c_str());
    ImGui::PushID("panels");
    const std::vector<std::string> names(selected.panels.begin(), selected.panels.end());
    const VectorEdit scale = vector_row(context,
                                        {.name = "panels.scale",
                                         .label = "Scale",
                                         .unit = Unit::Factor,
                                         .tip = "Scales all of them about their common middle: 1.05 or 105%.",
                                         .least = kMinScale},
                                        Vec2d(1, 1));
    if (scale)
        apply_edit(context, scale.number, scaling(names, all.center(), scale.axis, scale.number.value.value_or(1)));
    const VectorEdit moved = vector_row(
        context,
        {.name = "panels.move", .label = "Move by", .tip = "On the sheet; they stay where they are in the room."},
        Vec2d(0, 0));
    if (moved) apply_edit(context, moved.number, MovePanels{.panels = names, .by = edited(Vec2d(0, 0), moved)});
    const Vec3d centre = garment_centre(only_selected(pattern, selected));
    const VectorEdit placed = vector_row(context,
                                         {.name = "panels.translation",
                                          .label = "Place",
                                          .tip = "Moves all of them in the room, with their middle to this place."},
                                         centre);
    if (placed) apply_edit(context, placed.number, placing(pattern, selected, edited(centre, placed) - centre));
    fact(context, "Area", area_text(area), "Of the cloth inside their outlines.");
    ImGui::PopID();
}

// Points, edges, notches and internal lines of panels.

namespace {

constexpr double kShortestTyped = 0.001;  // m, lower limit for typed lengths

struct FoundPanel {
    const sim::Panel& panel;
    int index = 0;
    Vec2d origin = Vec2d::Zero();  // m, on the sheet
};

std::optional<FoundPanel> find(const sim::Pattern& pattern, const std::string& name) {
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
    apply_edit(context, moved.number, MoveVertices{.vertices = {vertex}, .by = by});
}

void draw_kind(InspectorContext& context, const PartRef& edge, const FoundPanel& found, const sim::OutlineEdge& curve) {
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
                                   .curve = with_kind(found.panel, curve, static_cast<sim::CurveKind>(chosen))});
}

void draw_controls(InspectorContext& context, const PartRef& edge, const FoundPanel& found,
                   const sim::OutlineEdge& curve) {
    const std::size_t count = curve.kind == sim::CurveKind::Quadratic ? 1 : curve.kind == sim::CurveKind::Cubic ? 2 : 0;
    constexpr std::array<const char*, 2> kNames{"edge.handle1", "edge.handle2"};
    for (std::size_t i = 0; i < count; ++i) {
        const char* label = count == 1 ? "Handle" : i == 0 ? "First handle" : "Second handle";
        const VectorEdit moved = vector_row(
            context, {.name = kNames[i], .label = label, .tip = "Where the curve's handle lies on the sheet."},
            Vec2d(curve.control[i] + found.origin));
        if (!moved) continue;
        SetCurve command{.panel = edge.panel, .edge = edge.index, .curve = curve};
        command.curve.control[i][moved.axis] = moved.number.value.value_or(0) - found.origin[moved.axis];
        return apply_edit(context, moved.number, command);
    }
}

void draw_arc(InspectorContext& context, const PartRef& edge, const FoundPanel& found, const sim::OutlineEdge& curve) {
    SetCurve command{.panel = edge.panel, .edge = edge.index, .curve = curve};
    const NumberEdit radius = number_row(context,
                                         {.name = "edge.radius",
                                          .value = curve.arc_radius,
                                          .tip = "Of the circle; half the distance of the ends or more.",
                                          .least = min_arc_radius(found.panel, curve)},
                                         "Radius");
    if (radius) {
        command.curve.arc_radius = radius.value.value_or(curve.arc_radius);
        return apply_edit(context, radius, command);
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

void draw_length_move(InspectorContext& context) {
    const std::array<std::string, 4> moves{"its end", "its start", "both ends", "parallel, along its neighbours"};
    auto& move = context.state.length_move;
    row_label(context, "Moves",
              "What moves when a length is typed. The triangles on the sheet point from start to end.");
    const int chosen =
        choice_box(context, {.name = "edge.length_move",
                             .shown = moves[static_cast<std::size_t>(move)],
                             .items = moves,
                             .chosen = static_cast<int>(move),
                             .tip = "Parallel: both ends slide along the neighbouring edges; the direction stays.",
                             .width_px = field_width()});
    if (chosen >= 0) move = static_cast<LengthMove>(chosen);
}

void draw_length(InspectorContext& context, const PartRef& edge, const FoundPanel& found,
                 const sim::OutlineEdge& curve) {
    const NumberEdit length = number_row(context,
                                         {.name = "edge.length",
                                          .value = outline_length(found.panel, curve),
                                          .tip = "Type a length. The row below says what moves.",
                                          .least = kShortestTyped},
                                         "Length");
    draw_length_move(context);
    if (!length) return;
    const double before = length.before.value_or(0);
    try {
        apply_edit(context, length,
                   command_for_length(context.pattern(), edge, context.state.length_move,
                                      {.before = before, .after = length.value.value_or(before)}));
    } catch (const GeometryError& error) {
        context.workspace.messages.error(error);
    }
}

void draw_seam_of(InspectorContext& context, const FoundPanel& found, int edge) {
    const std::optional<int> seam = seam_at(context.pattern(), {.panel = found.index, .edge = edge});
    if (!seam) {
        fact(context, "Seam", "not sewn", "No seam runs along this edge.");
        return;
    }
    const sim::Seam& sewn = context.pattern().seams[static_cast<std::size_t>(*seam)];
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
        apply_edit(context, moved.number,
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
    // Copies: the next fields see a change one frame later.
    const sim::Panel panel = found->panel;
    const FoundPanel shown{.panel = panel, .index = found->index, .origin = found->origin};
    const sim::OutlineEdge curve = panel.edges[static_cast<std::size_t>(edge.index)];
    draw_length(context, edge, shown, curve);
    draw_kind(context, edge, shown, curve);
    draw_controls(context, edge, shown, curve);
    if (curve.kind == sim::CurveKind::Arc) draw_arc(context, edge, shown, curve);
    const sim::OutlineEdge standing{.allowance = panel.allowance.value_or(context.pattern().allowance)};
    field_rows(context, {.part = FieldOwner::Edge, .panel = edge.panel, .index = edge.index}, curve, standing);
    draw_seam_of(context, shown, edge.index);
    ImGui::PopID();
}

void draw_notch_section(InspectorContext& context, const PartRef& notch) {
    const auto found = find(context.pattern(), notch.panel);
    if (!found || static_cast<std::size_t>(notch.index) >= found->panel.notches.size()) return;
    const sim::Notch held = found->panel.notches[static_cast<std::size_t>(notch.index)];
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
        apply_edit(context, from_start, command);
    } else if (from_end) {
        command.t = std::clamp(1 - from_end.value.value_or(0) / length, 0.0, 1.0);
        apply_edit(context, from_end, command);
    }
    field_rows(context, {.part = FieldOwner::Notch, .panel = notch.panel, .index = notch.index}, held);
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
    const sim::InternalLine held = found->panel.internal_lines[static_cast<std::size_t>(line.index)];
    double length = 0;
    for (std::size_t i = 1; i < held.points.size(); ++i) length += (held.points[i] - held.points[i - 1]).norm();
    heading(context, ("Internal line of " + line.panel).c_str());
    ImGui::PushID(("line " + line.panel + "." + std::to_string(line.index)).c_str());
    field_rows(context, {.part = FieldOwner::InternalLine, .panel = line.panel, .index = line.index}, held);
    fact(context, "Length", quantity_text(length, Unit::Centimetres), "From its first point to its last.");
    fact(context, "Points", std::to_string(held.points.size()), "That the line goes through.");
    ButtonRow row(context);
    if (row.button({.name = "line.delete", .title = "Delete", .tip = "Removes the line (Del)."})) {
        context.workspace.run(RemoveParts{.internal_lines = {line}});
    }
    ImGui::PopID();
}

// The property inspector: the selected objects, then the garment.

namespace {

constexpr double kUsualEdgeLength = 0.05;  // m, default of the mesher

void draw_selected(InspectorContext& context, const Selection& selected) {
    const std::size_t sewings = one_of_each_sewing(context.pattern(), selected.seams).size();
    if (sewings == 1) draw_seam_section(context, *selected.seams.begin());
    if (sewings > 1) {
        heading(context, (std::to_string(sewings) + " seams").c_str());
        paragraph(context, "The list of seams shows each of them.");
    }
    for (const PartRef& notch : selected.notches) draw_notch_section(context, notch);
    for (const PartRef& line : selected.internal_lines) draw_internal_line_section(context, line);
    for (const PartRef& edge : selected.edges) draw_edge_section(context, edge);
    if (!selected.vertices.empty()) draw_vertices_section(context);
    if (selected.panels.size() == 1) draw_panel_section(context, *selected.panels.begin());
    if (selected.panels.size() > 1) draw_panels_section(context);
}

}  // namespace

void fabric_row(InspectorContext& context, const std::string& panel) {
    const sim::Pattern& pattern = context.pattern();
    const std::optional<int> index = panel_index(pattern, panel);
    const std::string own = index ? pattern.panels[static_cast<std::size_t>(*index)].fabric : pattern.fabric;
    const std::string usual = index && !pattern.fabric.empty() ? pattern.fabric : sim::Fabric{}.name;
    std::vector<std::string> names = sim::fabric_names(),
                             shown{(index ? "As the garment: " : "Usual: ") + readable_name(usual)};
    int chosen = own.empty() ? 0 : -1;
    for (const std::string& name : names) {
        if (name == own) chosen = static_cast<int>(shown.size());
        shown.push_back(readable_name(name));
    }
    row_label(context, "Fabric", "What it is made of; its figures stand under Materials.");
    const int now = choice_box(context, {.name = panel.empty() ? "pattern.fabric" : "panel.fabric",
                                         .shown = own.empty() ? shown[0] : readable_name(own),
                                         .items = shown,
                                         .chosen = chosen,
                                         .tip = panel.empty() ? "The fabric of all panels that have none of their own."
                                                              : "The fabric of this panel.",
                                         .width_px = field_width()});
    if (now < 0) return;
    context.workspace.run(
        SetFabric{.panel = panel, .fabric = now == 0 ? "" : names[static_cast<std::size_t>(now) - 1]});
}

void draw_pattern_section(InspectorContext& context) {
    const sim::Pattern& pattern = context.pattern();
    ImGui::PushID("pattern");
    row_label(context, "Name", "What the garment is called.");
    const auto name = text_box(context, {.name = "pattern.name",
                                         .text = pattern.name,
                                         .hint = "unnamed",
                                         .tip = "What the garment is called.",
                                         .width_px = field_width()});
    if (name) context.workspace.run(RenamePattern{*name});
    const VectorEdit moved = vector_row(context,
                                        {.name = "pattern.translation",
                                         .label = "All panels",
                                         .tip = "Moves all panels in the room, with their middle to this place."},
                                        garment_centre(pattern));
    if (moved) {
        Vec3d by = Vec3d::Zero();
        by[moved.axis] = moved.number.by();
        apply_edit(context, moved.number, TranslateAll{by});
    }
    fabric_row(context, "");
    sim::Pattern standing;
    standing.edge_length = kUsualEdgeLength;
    field_rows(context, pattern, standing);
    fact(context, "Parts",
         sim::count_text(pattern.panels.size(), "panel") + ", " + sim::count_text(pattern.seams.size(), "seam"),
         "What the garment consists of.");
    ImGui::PopID();
}

void draw_properties(InspectorContext& context) {
    const Selection selected = context.selection();  // a copy: fields may change it
    if (context.pattern().panels.empty()) {
        paragraph(context, "No panels yet. Draw one on the sheet, or open a file.");
    } else if (selected.is_empty()) {
        paragraph(context, "Click a panel, point, edge or seam to see its values here.");
    }
    draw_selected(context, selected);
    if (folding("Garment", Fold::Open)) draw_pattern_section(context);
    if (!context.pattern().underlays.empty() && folding("Photos under the sheet", Fold::Open))
        draw_underlays_section(context);
    if (has_garments_section(context) && folding("Worn over each other", Fold::Open)) draw_garments_section(context);
}

}  // namespace selvedge::editor
