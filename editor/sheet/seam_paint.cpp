#include "editor/sheet/seam_paint.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "editor/drafting/seam_edit.h"
#include "editor/tools/sewing_tool.h"
#include "render/scene/colour_map.h"

namespace selvedge {
namespace {

struct SeamLook {
    Rgba8 colour{};
    double width = 2;
    bool is_uneven = false;
    bool is_marked = false;  // selected or pointed to
};

const PanelShape* shape_of(const SheetLook& look, const SeamSide& side) {
    const std::vector<PanelShape>& panels = look.geometry.panels();
    if (side.panel < 0 || static_cast<std::size_t>(side.panel) >= panels.size()) return nullptr;
    const PanelShape& shape = panels[static_cast<std::size_t>(side.panel)];
    if (side.edge < 0 || static_cast<std::size_t>(side.edge) >= shape.edges.size()) return nullptr;
    return &shape;
}

double length_of(const PanelShape& shape, const SeamSide& side) {
    return shape.edges[static_cast<std::size_t>(side.edge)].length;
}

SeamLook look_of(const SheetLook& look, int index, double difference) {
    const Seam& seam = look.pattern.seams[static_cast<std::size_t>(index)];
    SeamLook drawn;
    drawn.is_uneven = std::abs(difference) > kUnevenSeam && !seam.is_eased;
    drawn.is_marked = look.selection.seams.contains(index) || look.hover.seam == index;
    const Rgb8 kind = line_colour(static_cast<std::size_t>(index));
    drawn.colour = drawn.is_uneven ? look.pen.colours.error : Rgba8{kind[0], kind[1], kind[2], 255};
    const bool stands_out = drawn.is_marked || look.overlay.shows_sewing;
    drawn.width = drawn.is_marked ? 3.4 : stands_out ? 2.6 : 1.8;
    if (!stands_out) drawn.colour = faded(drawn.colour, 0.85);
    return drawn;
}

void draw_side(const SheetLook& look, const SeamSide& side, const SeamLook& drawn, bool runs_backward) {
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

// The difference stands inside of the panel, beside the middle of the side that is changed to even it.
void draw_difference(const SheetLook& look, const SeamSide& side, double difference, const Rgba8& colour) {
    const PanelShape* shape = shape_of(look, side);
    const EdgeShape& edge = shape->edges[static_cast<std::size_t>(side.edge)];
    const Vec2d along = edge.tangent(0.5);
    const std::string words = in_mm(difference);
    const float reach = look.pen.px(10) + 0.5F * ImGui::CalcTextSize(words.c_str()).x * float(std::abs(along.y())) +
                        0.5F * ImGui::GetTextLineHeight() * float(std::abs(along.x()));
    const ImVec2 offset{float(-along.y()) * reach, float(-along.x()) * reach};
    look.pen.words(shape->on_sheet(edge.at(0.5)), words, colour, offset);
}

void draw_button(const SheetLook& look, int seam, const Rgba8& colour) {
    const std::optional<Vec2d> at = seam_button(look.geometry, look.pattern, seam);
    if (!at) return;
    const SheetPen& pen = look.pen;
    pen.round(*at, 7, pen.colours.handle, colour);
    const ImVec2 middle = pen.px(*at);
    for (const float side : {-1.0F, 1.0F}) {  // two arrows that pass each other
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
    const auto add = [&](const LinePlace& place) {  // to the left in the sheet, whose y is turned over
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

void draw_seams(const SheetLook& look) {
    if (!look.shows.seams) return;
    for (std::size_t i = 0; i < look.pattern.seams.size(); ++i) {
        const Seam& seam = look.pattern.seams[i];
        const PanelShape* first = shape_of(look, seam.first);
        const PanelShape* second = shape_of(look, seam.second);
        if (first == nullptr || second == nullptr) continue;
        const int index = static_cast<int>(i);
        const double difference = length_of(*second, seam.second) - length_of(*first, seam.first);
        const SeamLook drawn = look_of(look, index, difference);
        draw_side(look, seam.first, drawn, false);
        draw_side(look, seam.second, drawn, seam.is_reversed);
        const bool is_told = drawn.is_uneven || (drawn.is_marked && std::abs(difference) > kUnevenSeam);
        if (is_told && is_in_view(look, *second)) draw_difference(look, seam.second, difference, drawn.colour);
        if (look.selection.seams.contains(index) && look.overlay.shows_sewing) draw_button(look, index, drawn.colour);
    }
}

}  // namespace selvedge
