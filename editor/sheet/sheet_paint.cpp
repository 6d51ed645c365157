#include "editor/sheet/sheet_paint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>

#include "editor/frame/item.h"
#include "editor/geometry/seam_edit.h"
#include "editor/geometry/sewing.h"
#include "editor/sheet/sheet_labels.h"
#include "editor/tools/sewing_tools.h"
#include "editor/tools/sheet_pick.h"
#include "render/scene/colour.h"
#include "sim/pattern/sources.h"

namespace selvedge::editor {
namespace {

ImTextureID id_of(UiTexture texture) {
    return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture));
}

// Texture coordinates of a panel point.
ImVec2 cloth_uv(const ClothTexture& cloth, const sim::Panel& panel, const Vec2d& u) {
    const double c = std::cos(panel.grain_angle), s = std::sin(panel.grain_angle);
    const Vec2d turned(c * u.x() + s * u.y(), -s * u.x() + c * u.y());
    const Vec2d place = turned + panel.sett_offset;
    const Vec3f at(static_cast<float>(place.x()), static_cast<float>(place.y()), 1);
    return {cloth.rows[0].dot(at), cloth.rows[1].dot(at)};
}

template <class Place>
void fill(const SheetLook& look, const PanelShape& shape, const PanelFace& face, const render::Rgba8& colour,
          Place&& uv_of) {
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

void fill_plain(const SheetLook& look, const PanelShape& shape, const render::Rgba8& colour) {
    const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
    const PanelFace& face = look.faces.face(shape, look.pen.camera.scale);
    if (!face.triangles.empty()) fill(look, shape, face, colour, [&](const Vec2d&) { return white; });
}

std::vector<Vec2d> on_sheet(const PanelShape& shape, std::vector<Vec2d> points) {
    for (Vec2d& point : points) point = shape.on_sheet(point);
    return points;
}

// A line along the warp, with an arrow head at both ends.
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

void draw_name(const SheetLook& look, const PanelShape& shape, const PanelName& name) {
    const SheetPen& pen = look.pen;
    if (!name.has_room) return;
    draw_grainline(look, shape, name.middle,
                   std::min(0.30 * shape.box.sizes().y(), 0.5 * shape.box.sizes().minCoeff()));
    if (name.shown.empty()) return;
    const bool is_selected = look.selection.panels.contains(shape.panel.name);
    pen.text(shape.on_sheet(name.middle), name.shown, is_selected ? pen.colours.accent : pen.colours.ink, {0, 0},
             name.size);
    const auto link = sim::link_of(shape.panel);
    if (!link) return;
    const Vec2d size_px = shape.box.sizes() * pen.camera.scale / double(pen.ui);
    const std::string mirrored = (link->kind == sim::Derivation::Mirror ? "mirrors " : "copy of ") + link->source;
    const double below = double(ImGui::CalcTextSize(mirrored.c_str()).x) / double(pen.ui) + 40;
    const double small = std::min(0.85, size_px.x() / below);
    if (small < kSmallestName || size_px.y() < 80) return;
    pen.text(shape.on_sheet(name.middle), mirrored, pen.colours.mirrored, {0, ImGui::GetTextLineHeight() + pen.px(2)},
             static_cast<float>(small));
}

void draw_notch(const SheetLook& look, const PanelShape& shape, std::size_t index) {
    const SheetPen& pen = look.pen;
    const sim::Notch& notch = shape.panel.notches[index];
    if (notch.edge < 0 || static_cast<std::size_t>(notch.edge) >= shape.edges.size()) return;
    const EdgeShape& edge = shape.edges[static_cast<std::size_t>(notch.edge)];
    const Vec2d at = edge.at(notch.t), along = edge.tangent(notch.t), inward(-along.y(), along.x());
    const PartRef ref{shape.panel.name, static_cast<int>(index)};
    const bool is_chosen = look.selection.notches.contains(ref), is_hovered = look.hover.notch == ref;
    const double px = double(pen.ui) / pen.camera.scale;
    const double depth = std::clamp(0.006, 6 * px, 13 * px);
    const Vec2d half = along * depth * 0.38;
    const render::Rgba8& colour = is_chosen || is_hovered ? pen.colours.accent : pen.colours.ink;
    pen.list.AddTriangleFilled(pen.px(shape.on_sheet(at + half)), pen.px(shape.on_sheet(at - half)),
                               pen.px(shape.on_sheet(at + inward * depth)), packed(colour));
}

render::Rgba8 thread_colour(const sim::Thread& thread) {
    unsigned red = 255, green = 255, blue = 255;
    std::sscanf(thread.colour.c_str(), "#%2x%2x%2x", &red, &green, &blue);
    return {static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green), static_cast<std::uint8_t>(blue), 255};
}

// Stitches of so many px along the line; a plain line where they could not be told apart, or would be too many to draw.
void draw_stitches(const SheetPen& pen, std::span<const ImVec2> line, double stitch, ImU32 colour, float width) {
    constexpr double kThread = 0.7;          // of a stitch: the rest is below the cloth
    constexpr double kMostStitches = 10000;  // of one line
    double length = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        length += std::hypot(line[i + 1].x - line[i].x, line[i + 1].y - line[i].y);
    if (stitch < pen.px(3) || length > kMostStitches * stitch) {
        pen.list.AddPolyline(line.data(), static_cast<int>(line.size()), colour, 0, width);
        return;
    }
    double before = 0;  // px of the line before its present part
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const ImVec2 along{line[i + 1].x - line[i].x, line[i + 1].y - line[i].y};
        const double part = std::hypot(along.x, along.y);
        const auto place = [&](double way) {
            const auto share = static_cast<float>(way / part);
            return ImVec2(line[i].x + along.x * share, line[i].y + along.y * share);
        };
        for (double k = std::floor(before / stitch); k * stitch < before + part; ++k) {
            const double from = std::max(0.0, k * stitch - before);
            const double to = std::min(part, (k + kThread) * stitch - before);
            if (from < to) pen.list.AddLine(place(from), place(to), colour, width);
        }
        before += part;
    }
}

// The rows to the left of a line of the panel, if `side` is 1; to its right, mirrored to the left, if it is -1; both if
// it is 0.
void draw_topstitch(const SheetLook& look, const PanelShape& shape, const std::vector<Vec2d>& points,
                    const std::optional<sim::Topstitch>& topstitch, int side = 0) {
    if (!topstitch || points.size() < 2) return;
    const SheetPen& pen = look.pen;
    std::vector<ImVec2> line;
    for (const Vec2d& point : points) line.push_back(pen.px(shape.on_sheet(point)));
    const ImU32 colour = packed(thread_colour(topstitch->thread));
    const auto px_of = [&](double length) { return static_cast<float>(length * pen.camera.scale); };
    for (int row = 0; row < topstitch->rows; ++row) {
        const double distance = topstitch->distances.x() + row * topstitch->distances.y();
        if (side != 0 && side * distance < 0) continue;
        const std::vector<ImVec2> stitches = inset_line(line, px_of(side < 0 ? -distance : distance), 0);
        draw_stitches(pen, stitches, px_of(topstitch->stitch_length), colour,
                      std::max(pen.px(1), px_of(topstitch->thread.thickness)));
    }
}

// A zigzag inside of an edge, and how long its elastic is at rest.
void draw_elastic(const SheetLook& look, const PanelShape& shape, std::size_t index, const std::vector<Vec2d>& points) {
    const SheetPen& pen = look.pen;
    std::vector<ImVec2> line;
    for (const Vec2d& point : points) line.push_back(pen.px(shape.on_sheet(point)));
    const double length = px_length(line), step = static_cast<double>(pen.px(5));
    if (line.size() < 2 || length < 4 * step) return;
    std::vector<ImVec2> zigzag;
    for (int i = 0; i * step <= length; ++i) {
        const LinePoint on = place_on(line, i * step);
        const float inward = pen.px(i % 2 == 0 ? 2 : 6);
        zigzag.push_back({on.at.x + inward * on.along.y, on.at.y - inward * on.along.x});
    }
    pen.list.AddPolyline(zigzag.data(), static_cast<int>(zigzag.size()), packed(pen.colours.ink), 0, pen.px(1.3));
    const double rest = shape.panel.edges[index].elastic->share * length / pen.camera.scale;
    const std::string text = "elastic " + in_cm(rest);
    constexpr float kSmall = 0.8F;
    if (static_cast<double>(kSmall * ImGui::CalcTextSize(text.c_str()).x) > length) return;  // it would cover others
    const EdgeShape& edge = shape.edges[index];
    const Vec2d along = edge.tangent(0.5), inward(-along.y(), along.x());
    pen.text(shape.on_sheet(edge.at(0.5) + inward * (18 * double(pen.ui) / pen.camera.scale)), text, pen.colours.ink,
             {0, 0}, kSmall);
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
    if (!shape.may_be_picked) return;
    const bool is_touched = look.touched.contains(name);
    const bool is_pointed = look.hover.panel == name && look.hover.vertex;
    if (!is_touched && !is_pointed && !look.overlay.shows_vertices) return;
    const double side = is_touched ? 6.5 : 5;
    for (std::size_t i = 0; i < shape.panel.vertices.size(); ++i) {
        const PartRef ref{name, static_cast<int>(i)};
        const bool is_chosen = look.selection.vertices.contains(ref);
        const render::Rgba8& rim = is_touched || is_chosen ? pen.colours.accent : pen.colours.faint_ink;
        pen.square(shape.on_sheet(shape.panel.vertices[i]), is_chosen ? 8 : side,
                   is_chosen ? pen.colours.accent : pen.colours.handle, rim);
    }
}

void draw_curve_handles(const SheetLook& look, const PanelShape& shape) {
    const SheetPen& pen = look.pen;
    if (!shape.may_be_picked) return;
    for (std::size_t i = 0; i < shape.panel.edges.size(); ++i) {
        const sim::OutlineEdge& edge = shape.panel.edges[i];
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
    return !shape.is_hidden && !shape.box.isEmpty() && visible_box(look.pen.camera).intersects(shape.sheet_box());
}

void draw_cut_line(const SheetLook& look, const PanelShape& shape) {
    const sim::CutLine* cut =
        look.cut_lines != nullptr && look.shows.allowances ? look.cut_lines->find(shape.panel, look.pattern) : nullptr;
    if (cut == nullptr || cut->outline.empty()) return;
    std::vector<Vec2d> line = on_sheet(shape, cut->outline);
    line.push_back(line.front());
    look.pen.line(line, look.pen.colours.cut, 1.2);
    const auto draw_notch = [&](const sim::NotchLine& notch) {
        const std::array<Vec2d, 2> out{shape.on_sheet(notch.on_outline), shape.on_sheet(notch.on_cut)};
        look.pen.line(out, look.pen.colours.cut, 1.2);
    };
    for (const sim::NotchLine& notch : cut->notches) draw_notch(notch);
    for (const sim::DartLines& dart : cut->darts) draw_notch(dart.begin), draw_notch(dart.end);
}

void draw_cloth(const SheetLook& look, const PanelShape& shape) {
    const SheetColours& colours = look.pen.colours;
    const PanelFace& face = look.faces.face(shape, look.pen.camera.scale);
    if (face.triangles.empty()) return;
    const ClothTexture cloth = look.cloth_of && look.shows.cloth ? look.cloth_of(shape.panel) : ClothTexture{};
    const bool is_plain = cloth.texture == 0;
    fill_plain(look, shape, faded(is_plain ? colours.plain_cloth : colours.under_cloth, look.cloth_opacity));
    if (!is_plain) {
        look.pen.list.PushTextureID(id_of(cloth.texture));
        fill(look, shape, face, faded({255, 255, 255, 255}, double(colours.cloth_strength) * look.cloth_opacity),
             [&](const Vec2d& u) { return cloth_uv(cloth, shape.panel, u); });
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
    const render::Rgba8& unchosen = shape.may_be_picked ? pen.colours.ink : pen.colours.locked;
    const render::Rgba8& colour = is_chosen ? pen.colours.accent : unchosen;
    pen.list.AddPolyline(line.data(), count, packed(colour), ImDrawFlags_Closed, pen.px(is_chosen ? 2 : 1.3));
}

void draw_marks(const SheetLook& look, const PanelShape& shape, const PanelName& name) {
    const SheetPen& pen = look.pen;
    for (std::size_t i = 0; i < shape.panel.internal_lines.size(); ++i) {
        const PartRef ref{shape.panel.name, static_cast<int>(i)};
        const std::vector<Vec2d> points = on_sheet(shape, shape.panel.internal_lines[i].points);
        const bool is_chosen = look.selection.internal_lines.contains(ref);
        if (look.hover.internal_line == ref) pen.line(points, faded(pen.colours.hover, 0.6), 4);
        pen.dashed(points, is_chosen ? pen.colours.accent : pen.colours.ink, is_chosen ? 2 : 1.2);
        const sim::InternalLine& line = shape.panel.internal_lines[i];
        draw_topstitch(look, shape, line.points, line.topstitch);
    }
    const PanelFace& face = look.faces.face(shape, pen.camera.scale);
    for (std::size_t e = 0; e < shape.panel.edges.size() && e + 1 < face.edge_starts.size(); ++e) {
        const sim::OutlineEdge& edge = shape.panel.edges[e];
        if (edge.topstitch) draw_topstitch(look, shape, edge_points(face, e), edge.topstitch);
        if (edge.elastic) draw_elastic(look, shape, e, edge_points(face, e));
    }
    for (std::size_t i = 0; i < shape.panel.notches.size(); ++i) draw_notch(look, shape, i);
    if (look.shows.names) draw_name(look, shape, name);
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

void draw_lengths(const SheetLook& look, const PanelShape& shape) {
    const SheetPen& pen = look.pen;
    constexpr double kBeside = 12, kInside = -14, kFree = 8;  // px: from the edge; of the edge beyond the text
    constexpr float kSize = 0.85F;                            // relative to the normal font size
    for (std::size_t e = 0; e < shape.edges.size(); ++e) {
        const EdgeShape& edge = shape.edges[e];
        const bool is_selected = look.selection.edges.contains({shape.panel.name, static_cast<int>(e)});
        if (!is_selected && !look.shows.lengths) continue;
        const std::string text = in_cm(edge.length);
        const LabelBox whole = pen.text_box(shape.on_sheet(edge.at(0.5)), text, {0, 0}, kSize);
        const ImVec2 size{whole.high.x - whole.low.x, whole.high.y - whole.low.y};
        if (!is_selected && edge.length * pen.camera.scale < double(size.x) + pen.px(kFree)) continue;
        std::vector<ImVec2> centres;
        for (const double t : {0.5, 0.3, 0.7}) {
            const Vec2d tangent = edge.tangent(t);
            const ImVec2 at = pen.px(shape.on_sheet(edge.at(t)));
            const double reach =
                std::abs(tangent.y()) * double(size.x) / 2 + std::abs(tangent.x()) * double(size.y) / 2;
            for (const double beside :
                 {kBeside, kInside}) {  // to the right of an edge is outside; y of the screen is down
                const double away = std::copysign(reach + pen.px(std::abs(beside)) / 2, beside);
                centres.push_back({at.x + float(tangent.y() * away), at.y + float(tangent.x() * away)});
            }
        }
        const ImVec2 centre = look.labels.place(size, centres), middle = pen.px(shape.on_sheet(edge.at(0.5)));
        pen.text(shape.on_sheet(edge.at(0.5)), text, is_selected ? pen.colours.accent : pen.colours.measure,
                 {centre.x - middle.x, centre.y - middle.y}, kSize);
    }
}

void draw_hovered(const SheetLook& look) {
    const SheetPen& pen = look.pen;
    const PanelShape* hovered = look.geometry.find(look.hover.panel);
    if (hovered != nullptr && hovered->is_hidden) return;
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

namespace {

struct SeamLook {
    render::Rgba8 colour{};
    double width = 2;
    bool is_uneven = false;
    bool is_marked = false;  // selected or hovered
};

const PanelShape* shape_of(const SheetLook& look, const sim::SeamSide& side) {
    const std::vector<PanelShape>& panels = look.geometry.panels();
    if (side.panel < 0 || static_cast<std::size_t>(side.panel) >= panels.size()) return nullptr;
    const PanelShape& shape = panels[static_cast<std::size_t>(side.panel)];
    if (side.edge < 0 || static_cast<std::size_t>(side.edge) >= shape.edges.size()) return nullptr;
    return &shape;
}

double length_of(const PanelShape& shape, const sim::SeamSide& side) {
    return shape.edges[static_cast<std::size_t>(side.edge)].length;
}

SeamLook look_of(const SheetLook& look, int index, double difference) {
    const sim::Seam& seam = look.pattern.seams[static_cast<std::size_t>(index)];
    SeamLook drawn;
    drawn.is_uneven = std::abs(difference) > kUnevenSeam && !seam.is_eased;
    drawn.is_marked = look.selection.seams.contains(index) || look.hover.seam == index;
    const sim::Rgb8 kind = render::line_colour(static_cast<std::size_t>(first_of_sewing(look.pattern, index)));
    drawn.colour = drawn.is_uneven ? look.pen.colours.error : render::Rgba8{kind[0], kind[1], kind[2], 255};
    const bool stands_out = drawn.is_marked || look.overlay.shows_sewing;
    drawn.width = drawn.is_marked ? 3.4 : stands_out ? 2.6 : 1.8;
    if (!stands_out) drawn.colour = faded(drawn.colour, 0.85);
    return drawn;
}

void draw_side(const SheetLook& look, const sim::SeamSide& side, const SeamLook& drawn, bool runs_backward) {
    const PanelShape* shape = shape_of(look, side);
    if (shape == nullptr || !is_in_view(look, *shape)) return;
    const SheetPen& pen = look.pen;
    const PanelFace& face = look.faces.face(*shape, pen.camera.scale);
    std::vector<ImVec2> line;
    for (const Vec2d& u : edge_points(face, static_cast<std::size_t>(side.edge))) {
        line.push_back(pen.px(shape->on_sheet(u)));
    }
    std::vector<ImVec2> inner = inset_line(line, pen.px(3.6), pen.px(6));
    if (inner.size() < 2) return;
    pen.list.AddPolyline(inner.data(), static_cast<int>(inner.size()), packed(pen.colours.plate), 0,
                         pen.px(drawn.width + 2.6));
    pen.list.AddPolyline(inner.data(), static_cast<int>(inner.size()), packed(drawn.colour), 0, pen.px(drawn.width));
    if (runs_backward) std::reverse(inner.begin(), inner.end());
    draw_direction(pen, inner, drawn.colour, runs_backward ? -1 : 1);
}

// Draws the length difference inside the panel, beside the mid-point of the side that "even" would change; where it
// would cover another text, farther along the edge, or outside.
void draw_difference(const SheetLook& look, const sim::SeamSide& side, double difference, const render::Rgba8& colour) {
    const PanelShape* shape = shape_of(look, side);
    const EdgeShape& edge = shape->edges[static_cast<std::size_t>(side.edge)];
    const std::string text = in_mm(difference);
    const LabelBox box = look.pen.text_box(shape->on_sheet(edge.at(0.5)), text);
    const ImVec2 size{box.high.x - box.low.x, box.high.y - box.low.y};
    std::vector<ImVec2> centres;
    for (const float inward : {1.0F, -1.0F}) {
        for (const double t : {0.5, 0.35, 0.65, 0.2, 0.8}) {
            const Vec2d along = edge.tangent(t);
            const float reach = look.pen.px(6) + 0.5F * size.x * float(std::abs(along.y())) +
                                0.5F * size.y * float(std::abs(along.x()));
            const ImVec2 at = look.pen.px(shape->on_sheet(edge.at(t)));
            centres.push_back({at.x - inward * reach * float(along.y()), at.y - inward * reach * float(along.x())});
        }
    }
    const ImVec2 centre = look.labels.place(size, centres), middle = look.pen.px(shape->on_sheet(edge.at(0.5)));
    look.pen.text(shape->on_sheet(edge.at(0.5)), text, colour, {centre.x - middle.x, centre.y - middle.y});
}

void draw_button(const SheetLook& look, int seam, const render::Rgba8& colour) {
    const std::optional<Vec2d> at = seam_button(look.geometry, look.pattern, seam);
    if (!at) return;
    const SheetPen& pen = look.pen;
    pen.round(*at, 7, pen.colours.handle, colour);
    const ImVec2 middle = pen.px(*at);
    for (const float side : {-1.0F, 1.0F}) {  // two arrows in opposite directions
        const float y = middle.y + side * pen.px(2), x = side * pen.px(4);
        pen.list.AddLine({middle.x - x, y}, {middle.x + x, y}, packed(colour), pen.px(1.3));
        pen.list.AddLine({middle.x + x, y}, {middle.x + x * 0.35F, y + side * pen.px(2.2)}, packed(colour),
                         pen.px(1.3));
    }
}

}  // namespace

std::vector<ImVec2> inset_line(std::span<const ImVec2> line, float inset, float trim) {
    const double length = px_length(line);
    if (line.size() < 2 || length < 3 * double(trim)) return {};
    std::vector<ImVec2> inner;
    const auto add = [&](const LinePoint& place) {  // left on the sheet: px have y down
        inner.push_back({place.at.x + place.along.y * inset, place.at.y - place.along.x * inset});
    };
    add(place_on(line, double(trim)));
    double reached = 0;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        const ImVec2 before{line[i].x - line[i - 1].x, line[i].y - line[i - 1].y};
        const ImVec2 after{line[i + 1].x - line[i].x, line[i + 1].y - line[i].y};
        const float a = std::hypot(before.x, before.y), b = std::hypot(after.x, after.y);
        reached += double(a);
        if (a <= 0 || b <= 0 || reached <= double(trim) || reached >= length - double(trim)) continue;
        const ImVec2 sum{before.x / a + after.x / b, before.y / a + after.y / b};
        const float size = std::hypot(sum.x, sum.y);
        if (size > 0.2F) add({line[i], {sum.x / size, sum.y / size}});
    }
    add(place_on(line, length - double(trim)));
    return inner;
}

namespace {

void draw_topstitch_of(const SheetLook& look, const sim::SeamSide& side, const sim::Seam& seam, int on) {
    const PanelShape* shape = shape_of(look, side);
    if (!seam.topstitch || shape == nullptr || !is_in_view(look, *shape)) return;
    const PanelFace& face = look.faces.face(*shape, look.pen.camera.scale);
    draw_topstitch(look, *shape, edge_points(face, static_cast<std::size_t>(side.edge)), seam.topstitch, on);
}

}  // namespace

void draw_seams(const SheetLook& look) {
    for (const sim::Seam& seam : look.pattern.seams) {
        draw_topstitch_of(look, seam.first, seam, 1);
        draw_topstitch_of(look, seam.second, seam, -1);
    }
    if (!look.shows.seams) return;
    for (std::size_t i = 0; i < look.pattern.seams.size(); ++i) {
        const sim::Seam& seam = look.pattern.seams[i];
        const PanelShape* first = shape_of(look, seam.first);
        const PanelShape* second = shape_of(look, seam.second);
        if (first == nullptr || second == nullptr || first->is_hidden || second->is_hidden) continue;
        const int index = static_cast<int>(i);
        const double difference = length_of(*second, seam.second) - length_of(*first, seam.first);
        const SeamLook drawn = look_of(look, index, difference);
        draw_side(look, seam.first, drawn, false);
        draw_side(look, seam.second, drawn, seam.is_reversed);
        const bool is_shown = drawn.is_uneven || (drawn.is_marked && std::abs(difference) > kUnevenSeam);
        if (is_shown && is_in_view(look, *second)) draw_difference(look, seam.second, difference, drawn.colour);
        if (look.selection.seams.contains(index) && look.overlay.shows_sewing) draw_button(look, index, drawn.colour);
    }
}

namespace {

render::Rgba8 colour_of(const SheetColours& colours, OverlayTone tone) {
    switch (tone) {
        case OverlayTone::Draft:
            return colours.accent;
        case OverlayTone::Faint:
            return colours.hover;
        case OverlayTone::Guide:
            return colours.guide;
        case OverlayTone::Measure:
            return colours.measure;
        case OverlayTone::Warning:
            return colours.warning;
    }
    return colours.accent;
}

void draw_line(const SheetPen& pen, const OverlayLine& line) {
    if (line.points.size() < 2) return;
    const render::Rgba8 colour = colour_of(pen.colours, line.tone);
    std::vector<ImVec2> drawn;
    for (const Vec2d& point : line.points) drawn.push_back(pen.px(point));
    if (line.is_closed && line.points.size() < 200) {
        pen.list.AddConvexPolyFilled(drawn.data(), static_cast<int>(drawn.size()), packed(faded(colour, 0.10)));
    }
    const bool is_thin = line.tone == OverlayTone::Faint || line.tone == OverlayTone::Guide;
    if (line.is_dashed) return pen.dashed(line.points, colour, is_thin ? 1 : 1.3, 4);
    pen.line(line.points, colour, line.has_ticks ? 3.2 : is_thin ? 1 : 1.8);
    if (line.has_ticks) draw_direction(pen, drawn, colour, 1);
}

void draw_handle(const SheetPen& pen, const OverlayHandle& handle) {
    const render::Rgba8 colour = colour_of(pen.colours, handle.tone);
    const render::Rgba8 inside = handle.is_filled ? colour : pen.colours.handle;
    const ImVec2 at = pen.px(handle.at);
    const float r = pen.px(4.5);
    switch (handle.shape) {
        case HandleShape::Square:
            return pen.square(handle.at, 7.5, inside, colour);
        case HandleShape::Round:
            return pen.round(handle.at, 4.6, inside, colour);
        case HandleShape::Diamond:
            pen.list.AddQuadFilled({at.x - r, at.y}, {at.x, at.y - r}, {at.x + r, at.y}, {at.x, at.y + r},
                                   packed(inside));
            return pen.list.AddQuad({at.x - r, at.y}, {at.x, at.y - r}, {at.x + r, at.y}, {at.x, at.y + r},
                                    packed(colour), pen.px(1.4));
        case HandleShape::Cross:
            pen.list.AddLine({at.x - r, at.y - r}, {at.x + r, at.y + r}, packed(colour), pen.px(1.4));
            return pen.list.AddLine({at.x - r, at.y + r}, {at.x + r, at.y - r}, packed(colour), pen.px(1.4));
    }
}

// Above its place, or below it, or farther away, where it covers no other text.
void draw_label(const SheetLook& look, const OverlayLabel& label) {
    const LabelBox box = look.pen.text_box(label.at, label.text);
    const ImVec2 size{box.high.x - box.low.x, box.high.y - box.low.y}, middle = look.pen.px(label.at);
    std::vector<ImVec2> centres;
    for (const double lines : {0.0, 1.0, 2.0}) {
        const float away = look.pen.px(14) + static_cast<float>(lines) * size.y;
        centres.push_back({middle.x, middle.y - away});
        centres.push_back({middle.x, middle.y + away});
    }
    const ImVec2 centre = look.labels.place(size, centres);
    look.pen.text(label.at, label.text, colour_of(look.pen.colours, label.tone), {0, centre.y - middle.y});
}

}  // namespace

void draw_overlay(const SheetLook& look) {
    for (const OverlayLine& line : look.overlay.lines) draw_line(look.pen, line);
    for (const OverlayHandle& handle : look.overlay.handles) draw_handle(look.pen, handle);
    for (const OverlayLabel& label : look.overlay.labels) draw_label(look, label);
}

void draw_lit_places(const SheetLook& look, const std::vector<PartLocation>& places) {
    const SheetPen& pen = look.pen;
    for (const PartLocation& place : places) {
        const PanelShape* shape = look.geometry.find(place.panel);
        if (shape == nullptr) continue;
        const bool has_edge = place.edge >= 0 && static_cast<std::size_t>(place.edge) < shape->edges.size();
        const bool has_vertex =
            place.vertex >= 0 && static_cast<std::size_t>(place.vertex) < shape->panel.vertices.size();
        std::vector<Vec2d> line;
        if (has_edge) line = shape->edges[static_cast<std::size_t>(place.edge)].points;
        if (!has_edge && !has_vertex) line = shape->outline;
        if (!has_edge && !line.empty()) line.push_back(line.front());
        for (Vec2d& point : line) point = shape->on_sheet(point);
        if (!line.empty()) {
            pen.line(line, faded(pen.colours.error, 0.3), 8);
            pen.line(line, pen.colours.error, 2.2);
        }
        if (!has_vertex) continue;
        const Vec2d at = shape->on_sheet(shape->panel.vertices[static_cast<std::size_t>(place.vertex)]);
        pen.round(at, 11, faded(pen.colours.error, 0.25), pen.colours.error);
    }
}

void draw_lit_cloth(const SheetLook& look, const std::vector<LitCloth::OnPanel>& lines) {
    const SheetPen& pen = look.pen;
    for (const LitCloth::OnPanel& line : lines) {
        const PanelShape* shape = look.geometry.find(line.panel);
        if (shape == nullptr) continue;
        const std::array<Vec2d, 2> ends{shape->on_sheet(line.ends[0]), shape->on_sheet(line.ends[1])};
        if (line.ends[0] == line.ends[1]) {
            pen.round(ends[0], 11, faded(pen.colours.error, 0.25), pen.colours.error);
        } else {
            pen.line(ends, pen.colours.error, 2.6);
        }
    }
}

ImVec2 bubble_corner(const SheetCamera& camera, const Vec2d& cursor, const Vec2d& size, double beside) {
    Vec2d corner = cursor + Vec2d(beside, beside);
    const Vec2d most = camera.view_low + camera.view_size - size;
    for (int i = 0; i < 2; ++i) {
        if (corner[i] > most[i]) corner[i] = cursor[i] - beside - size[i];
        corner[i] = std::round(std::max(camera.view_low[i], std::min(corner[i], most[i])));
    }
    return {float(corner.x()), float(corner.y())};
}

void draw_bubble(const SheetPen& pen, const Vec2d& cursor, const ToolOverlay& overlay, const ToolHost& tools) {
    const TypedInput& typed = tools.typed();
    const bool is_typing = tools.is_asking() || !typed.is_empty();
    std::vector<std::string> lines = overlay.readout;
    if (!overlay.problem.empty()) lines.insert(lines.begin(), overlay.problem);
    if (lines.empty() && !is_typing) return;
    const float line_height = ImGui::GetTextLineHeight() + pen.px(2), margin = pen.px(7);
    for (std::string& line : lines) line = elided(line, float(pen.camera.view_size.x()) - 2 * margin);
    float width = 0;
    for (const std::string& line : lines) width = std::max(width, ImGui::CalcTextSize(line.c_str()).x);
    const float large = ImGui::GetFontSize() * 1.25F;
    const std::string typed_text = typed.text() + "|";
    const ImVec2 typed_size = ImGui::GetFont()->CalcTextSizeA(large, 1e6F, 0, typed_text.c_str());
    if (is_typing) width = std::max(width, typed_size.x + pen.px(6));
    const float height = line_height * static_cast<float>(lines.size()) + (is_typing ? large + pen.px(8) : 0);
    const ImVec2 low = bubble_corner(pen.camera, cursor, {width + 2 * margin, height + 2 * margin}, double(pen.px(18)));
    pen.list.AddRectFilled(low, {low.x + width + 2 * margin, low.y + height + 1.4F * margin},
                           packed(pen.colours.bubble), pen.px(5));
    ImVec2 at{low.x + margin, low.y + 0.7F * margin};
    if (is_typing) {
        pen.list.AddRectFilled({at.x - pen.px(2), at.y}, {low.x + width + margin + pen.px(2), at.y + large + pen.px(4)},
                               packed(pen.colours.handle), pen.px(3));
        const render::Rgba8& ink = typed.numbers() || typed.is_empty() ? pen.colours.ink : pen.colours.error;
        pen.list.AddText(ImGui::GetFont(), large, {at.x + pen.px(1), at.y + pen.px(2)}, packed(ink),
                         typed_text.c_str());
        at.y += large + pen.px(8);
    }
    for (const std::string& line : lines) {
        const bool is_problem = !overlay.problem.empty() && &line == &lines.front();
        pen.list.AddText(at, packed(is_problem ? pen.colours.bubble_problem : pen.colours.bubble_text), line.c_str());
        at.y += line_height;
    }
}

}  // namespace selvedge::editor
