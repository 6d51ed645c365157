#include "editor/sheet/panel_paint.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "editor/tools/sheet_pick.h"

namespace selvedge {
namespace {

ImTextureID id_of(UiTexture texture) {
    return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture));
}

// (weft, warp) in units of the repeat.
ImVec2 sett_place(const SettTexture& sett, const Panel& panel, const Vec2d& u) {
    const double c = std::cos(panel.grain_angle), s = std::sin(panel.grain_angle);
    const Vec2d turned(c * u.x() + s * u.y(), -s * u.x() + c * u.y());
    const Vec2d place = (turned + panel.sett_offset - sett.position).cwiseQuotient(sett.repeat);
    return {static_cast<float>(place.x()), static_cast<float>(place.y())};
}

template <class Place>
void fill(const SheetLook& look, const PanelShape& shape, const PanelFace& face, const Rgba8& colour, Place&& uv_of) {
    ImDrawList& list = look.pen.list;
    list.PrimReserve(static_cast<int>(face.triangles.size() * 3), static_cast<int>(face.points.size()));
    const unsigned first = list._VtxCurrentIdx;
    for (const std::array<int, 3>& triangle : face.triangles) {
        for (const int corner : triangle)
            list.PrimWriteIdx(static_cast<ImDrawIdx>(first + static_cast<unsigned>(corner)));
    }
    const ImU32 packed_colour = packed(colour);
    for (const Vec2d& point : face.points) {
        list.PrimWriteVtx(look.pen.px(shape.on_sheet(point)), uv_of(point), packed_colour);
    }
}

void fill_plain(const SheetLook& look, const PanelShape& shape, const Rgba8& colour) {
    const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
    const PanelFace& face = look.faces.face(shape, look.pen.camera.scale);
    if (!face.triangles.empty()) fill(look, shape, face, colour, [&](const Vec2d&) { return white; });
}

std::vector<Vec2d> on_sheet(const PanelShape& shape, std::vector<Vec2d> points) {
    for (Vec2d& point : points) point = shape.on_sheet(point);
    return points;
}

// Where a panel's name stands: its middle, or, where that lies outside, the middle of its largest triangle.
Vec2d middle_of(const PanelShape& shape, const PanelFace& face) {
    Vec2d sum(0, 0), largest = shape.box.center();
    double area = 0, best = 0;
    for (const auto& [a, b, c] : face.triangles) {
        const Vec2d &p = face.points[std::size_t(a)], &q = face.points[std::size_t(b)],
                    &r = face.points[std::size_t(c)];
        const double part = cross2(q - p, r - p) / 2;
        const Vec2d centre = (p + q + r) / 3;
        sum += part * centre;
        area += part;
        if (part > best) largest = centre;
        best = std::max(best, part);
    }
    const Vec2d middle = area > 0 ? Vec2d(sum / area) : shape.box.center();
    return shape.contains(middle) ? middle : largest;
}

// Along the warp, with a head at either end.
void draw_grainline(const SheetLook& look, const PanelShape& shape, const Vec2d& middle, double half) {
    const SheetPen& pen = look.pen;
    const double angle = shape.panel.grain_angle;
    const Vec2d along(-std::sin(angle), std::cos(angle));
    const std::array<Vec2d, 2> line{shape.on_sheet(middle - half * along), shape.on_sheet(middle + half * along)};
    pen.line(line, pen.colours.faint_ink, 1.2);
    for (const double side : {-1.0, 1.0}) {
        const Vec2d tip = middle + side * half * along,
                    back = tip - side * along * (7 * double(pen.ui) / pen.camera.scale);
        const Vec2d across = Vec2d(-along.y(), along.x()) * (2.6 * double(pen.ui) / pen.camera.scale);
        pen.list.AddTriangleFilled(pen.px(shape.on_sheet(tip)), pen.px(shape.on_sheet(back + across)),
                                   pen.px(shape.on_sheet(back - across)), packed(pen.colours.faint_ink));
    }
}

void draw_name(const SheetLook& look, const PanelShape& shape) {
    const SheetPen& pen = look.pen;
    const Vec2d size_px = shape.box.sizes() * pen.camera.scale / double(pen.ui);
    if (size_px.minCoeff() < 34) return;
    const Vec2d middle = middle_of(shape, look.faces.face(shape, pen.camera.scale));
    draw_grainline(look, shape, middle, std::min(0.30 * shape.box.sizes().y(), 0.5 * shape.box.sizes().minCoeff()));
    const bool is_selected = look.selection.panels.contains(shape.panel.name);
    const double words = double(ImGui::CalcTextSize(shape.panel.name.c_str()).x) / double(pen.ui) + 56;
    const double share = std::min(1.0, size_px.x() / words);
    constexpr double kSmallest = 0.7;  // of the usual size that can still be read
    if (share < kSmallest) return;
    pen.words(shape.on_sheet(middle), shape.panel.name, is_selected ? pen.colours.accent : pen.colours.ink, {0, 0},
              static_cast<float>(share));
    if (shape.panel.mirror_of.empty()) return;
    const std::string mirrored = "mirrors " + shape.panel.mirror_of;
    const double below = double(ImGui::CalcTextSize(mirrored.c_str()).x) / double(pen.ui) + 40;
    const double small = std::min(0.85, size_px.x() / below);
    if (small < kSmallest || size_px.y() < 80) return;
    pen.words(shape.on_sheet(middle), mirrored, pen.colours.mirrored, {0, ImGui::GetTextLineHeight() + pen.px(2)},
              static_cast<float>(small));
}

void draw_notch(const SheetLook& look, const PanelShape& shape, std::size_t index) {
    const SheetPen& pen = look.pen;
    const Notch& notch = shape.panel.notches[index];
    if (notch.edge < 0 || static_cast<std::size_t>(notch.edge) >= shape.edges.size()) return;
    const EdgeShape& edge = shape.edges[static_cast<std::size_t>(notch.edge)];
    const Vec2d at = edge.at(notch.t), along = edge.tangent(notch.t), inward(-along.y(), along.x());
    const PartRef ref{shape.panel.name, static_cast<int>(index)};
    const bool is_chosen = look.selection.notches.contains(ref), is_hovered = look.hover.notch == ref;
    const double px = double(pen.ui) / pen.camera.scale;
    const double depth = std::clamp(0.006, 6 * px, 13 * px);
    const Vec2d half = along * depth * 0.38;
    const Rgba8& colour = is_chosen || is_hovered ? pen.colours.accent : pen.colours.ink;
    pen.list.AddTriangleFilled(pen.px(shape.on_sheet(at + half)), pen.px(shape.on_sheet(at - half)),
                               pen.px(shape.on_sheet(at + inward * depth)), packed(colour));
}

void draw_pin(const SheetPen& pen, const Vec2d& at) {
    const ImVec2 foot = pen.px(at);
    const ImVec2 head{foot.x + pen.px(6), foot.y - pen.px(10)};
    pen.list.AddLine(foot, head, packed(pen.colours.ink), pen.px(1.2));
    pen.list.AddCircleFilled(head, pen.px(3.6), packed(pen.colours.pin), 16);
}

void draw_vertices(const SheetLook& look, const PanelShape& shape) {
    const SheetPen& pen = look.pen;
    const std::string& name = shape.panel.name;
    const bool is_touched = look.touched.contains(name);
    const bool is_pointed = look.hover.panel == name && look.hover.vertex;
    if (!is_touched && !is_pointed && !look.overlay.shows_vertices) return;
    const double side = is_touched ? 6.5 : 5;
    for (std::size_t i = 0; i < shape.panel.vertices.size(); ++i) {
        const PartRef ref{name, static_cast<int>(i)};
        const bool is_chosen = look.selection.vertices.contains(ref);
        const Rgba8& rim = is_touched || is_chosen ? pen.colours.accent : pen.colours.faint_ink;
        pen.square(shape.on_sheet(shape.panel.vertices[i]), is_chosen ? 8 : side,
                   is_chosen ? pen.colours.accent : pen.colours.handle, rim);
    }
}

void draw_curve_handles(const SheetLook& look, const PanelShape& shape) {
    const SheetPen& pen = look.pen;
    for (std::size_t i = 0; i < shape.panel.edges.size(); ++i) {
        const OutlineEdge& edge = shape.panel.edges[i];
        const int count = control_count(edge.kind);
        if (count == 0 || !look.overlay.handle_edges.contains({shape.panel.name, static_cast<int>(i)})) continue;
        const Vec2d start = shape.on_sheet(shape.panel.vertices[std::size_t(edge.start)]);
        const Vec2d end = shape.on_sheet(shape.panel.vertices[std::size_t(edge.end)]);
        const Vec2d first = shape.on_sheet(edge.control[0]), last = shape.on_sheet(edge.control[count == 2 ? 1 : 0]);
        pen.line(std::array{start, first}, pen.colours.hover, 1.1);
        pen.line(std::array{last, end}, pen.colours.hover, 1.1);
        pen.round(first, 3.6, pen.colours.handle, pen.colours.accent);
        if (count == 2) pen.round(last, 3.6, pen.colours.handle, pen.colours.accent);
    }
}

}  // namespace

bool is_in_view(const SheetLook& look, const PanelShape& shape) {
    return !shape.box.isEmpty() && visible_box(look.pen.camera).intersects(shape.sheet_box());
}

void draw_cloth(const SheetLook& look, const PanelShape& shape) {
    const SheetColours& colours = look.pen.colours;
    const PanelFace& face = look.faces.face(shape, look.pen.camera.scale);
    if (face.triangles.empty()) return;
    const bool has_sett = look.sett.texture != 0 && look.shows.cloth;
    fill_plain(look, shape, has_sett ? colours.under_cloth : colours.plain_cloth);
    if (has_sett) {
        look.pen.list.PushTextureID(id_of(look.sett.texture));
        fill(look, shape, face, faded({255, 255, 255, 255}, double(colours.cloth_strength)),
             [&](const Vec2d& u) { return sett_place(look.sett, shape.panel, u); });
        look.pen.list.PopTextureID();
    }
    if (look.selection.panels.contains(shape.panel.name)) fill_plain(look, shape, colours.accent_fill);
}

void draw_outline(const SheetLook& look, const PanelShape& shape) {
    const SheetPen& pen = look.pen;
    const PanelFace& face = look.faces.face(shape, pen.camera.scale);
    if (face.points.size() < 2) return;
    const bool is_chosen = look.selection.panels.contains(shape.panel.name);
    const bool is_hovered = look.hover.panel == shape.panel.name;
    std::vector<ImVec2> line;
    line.reserve(face.points.size());
    for (const Vec2d& point : face.points) line.push_back(pen.px(shape.on_sheet(point)));
    const int count = static_cast<int>(line.size());
    if (is_hovered && !is_chosen) {
        pen.list.AddPolyline(line.data(), count, packed(faded(pen.colours.hover, 0.5)), ImDrawFlags_Closed, pen.px(4));
    }
    const Rgba8& colour = is_chosen ? pen.colours.accent : pen.colours.ink;
    pen.list.AddPolyline(line.data(), count, packed(colour), ImDrawFlags_Closed, pen.px(is_chosen ? 2 : 1.3));
}

void draw_marks(const SheetLook& look, const PanelShape& shape) {
    const SheetPen& pen = look.pen;
    for (std::size_t i = 0; i < shape.panel.internal_lines.size(); ++i) {
        const PartRef ref{shape.panel.name, static_cast<int>(i)};
        const std::vector<Vec2d> points = on_sheet(shape, shape.panel.internal_lines[i].points);
        const bool is_chosen = look.selection.internal_lines.contains(ref);
        if (look.hover.internal_line == ref) pen.line(points, faded(pen.colours.hover, 0.6), 4);
        pen.dashed(points, is_chosen ? pen.colours.accent : pen.colours.ink, is_chosen ? 2 : 1.2);
    }
    for (std::size_t i = 0; i < shape.panel.notches.size(); ++i) draw_notch(look, shape, i);
    if (look.shows.names) draw_name(look, shape);
    for (const int pin : shape.panel.pins) {
        const bool is_there = pin >= 0 && static_cast<std::size_t>(pin) < shape.panel.vertices.size();
        if (is_there) draw_pin(pen, shape.on_sheet(shape.panel.vertices[std::size_t(pin)]));
    }
}

void draw_selected(const SheetLook& look, const PanelShape& shape) {
    const PanelFace& face = look.faces.face(shape, look.pen.camera.scale);
    for (std::size_t i = 0; i + 1 < face.edge_starts.size(); ++i) {
        if (!look.selection.edges.contains({shape.panel.name, static_cast<int>(i)})) continue;
        look.pen.line(on_sheet(shape, edge_points(face, i)), look.pen.colours.accent, 3);
    }
    draw_curve_handles(look, shape);
    draw_vertices(look, shape);
}

void draw_hovered(const SheetLook& look) {
    const SheetPen& pen = look.pen;
    if (look.hover.edge && look.geometry.edge(*look.hover.edge) != nullptr) {
        const PanelShape& shape = *look.geometry.find(look.hover.edge->panel);
        const PanelFace& face = look.faces.face(shape, pen.camera.scale);
        const auto edge = static_cast<std::size_t>(look.hover.edge->index);
        pen.line(on_sheet(shape, edge_points(face, edge)), pen.colours.hover, 4);
    }
    if (!look.hover.vertex) return;
    const std::optional<Vec2d> at = look.geometry.vertex(*look.hover.vertex);
    if (!at) return;
    const bool is_chosen = look.selection.vertices.contains(*look.hover.vertex);
    pen.round(*at, 9, faded(pen.colours.hover, 0.35), faded(pen.colours.hover, 0));
    pen.square(*at, 8, is_chosen ? pen.colours.accent : pen.colours.handle, pen.colours.accent);
}

}  // namespace selvedge
