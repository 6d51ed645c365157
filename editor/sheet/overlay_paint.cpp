#include "editor/sheet/overlay_paint.h"

#include <algorithm>
#include <cmath>

namespace selvedge {
namespace {

Rgba8 colour_of(const SheetColours& colours, OverlayTone tone) {
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
    const Rgba8 colour = colour_of(pen.colours, line.tone);
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
    const Rgba8 colour = colour_of(pen.colours, handle.tone);
    const Rgba8 inside = handle.is_filled ? colour : pen.colours.handle;
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

}  // namespace

void draw_overlay(const SheetLook& look) {
    for (const OverlayLine& line : look.overlay.lines) draw_line(look.pen, line);
    for (const OverlayHandle& handle : look.overlay.handles) draw_handle(look.pen, handle);
    for (const OverlayLabel& label : look.overlay.labels) {
        look.pen.words(label.at, label.text, colour_of(look.pen.colours, label.tone), {0, -look.pen.px(14)});
    }
}

void draw_lit_places(const SheetLook& look, const std::vector<DraftPlace>& places) {
    const SheetPen& pen = look.pen;
    for (const DraftPlace& place : places) {
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

void draw_bubble(const SheetPen& pen, const Vec2d& cursor, const ToolOverlay& overlay, const TypedInput& typed) {
    std::vector<std::string> lines = overlay.readout;
    if (lines.empty() && typed.is_empty()) return;
    const float line_height = ImGui::GetTextLineHeight() + pen.px(2), margin = pen.px(7);
    float width = 0;
    for (const std::string& line : lines) width = std::max(width, ImGui::CalcTextSize(line.c_str()).x);
    const float large = ImGui::GetFontSize() * 1.25F;
    const std::string typed_text = typed.text() + "|";
    const bool is_typing = !typed.is_empty();
    const ImVec2 typed_size = ImGui::GetFont()->CalcTextSizeA(large, 1e6F, 0, typed_text.c_str());
    if (is_typing) width = std::max(width, typed_size.x + pen.px(6));
    const float height = line_height * static_cast<float>(lines.size()) + (is_typing ? large + pen.px(8) : 0);
    const Vec2d high = pen.camera.view_low + pen.camera.view_size;
    ImVec2 low{float(cursor.x()) + pen.px(18), float(cursor.y()) + pen.px(18)};
    if (low.x + width + 2 * margin > float(high.x())) low.x = float(cursor.x()) - pen.px(18) - width - 2 * margin;
    if (low.y + height + 2 * margin > float(high.y())) low.y = float(cursor.y()) - pen.px(18) - height - 2 * margin;
    low = {std::round(low.x), std::round(low.y)};
    pen.list.AddRectFilled(low, {low.x + width + 2 * margin, low.y + height + 1.4F * margin},
                           packed(pen.colours.bubble), pen.px(5));
    ImVec2 at{low.x + margin, low.y + 0.7F * margin};
    if (is_typing) {
        pen.list.AddRectFilled({at.x - pen.px(2), at.y}, {low.x + width + margin + pen.px(2), at.y + large + pen.px(4)},
                               packed(pen.colours.handle), pen.px(3));
        const Rgba8& ink = typed.numbers() ? pen.colours.ink : pen.colours.error;
        pen.list.AddText(ImGui::GetFont(), large, {at.x + pen.px(1), at.y + pen.px(2)}, packed(ink),
                         typed_text.c_str());
        at.y += large + pen.px(8);
    }
    for (const std::string& line : lines) {
        pen.list.AddText(at, packed(pen.colours.bubble_text), line.c_str());
        at.y += line_height;
    }
}

}  // namespace selvedge
