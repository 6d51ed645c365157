#include "editor/sheet/sheet_pen.h"

#include <algorithm>
#include <cmath>

namespace selvedge::editor {
namespace {

std::vector<ImVec2> in_px(const SheetPen& pen, std::span<const Vec2d> points) {
    std::vector<ImVec2> line;
    line.reserve(points.size());
    for (const Vec2d& point : points) line.push_back(pen.px(point));
    return line;
}

float distance(const ImVec2& a, const ImVec2& b) {
    return std::hypot(b.x - a.x, b.y - a.y);
}

// Skips segments outside the view: dashing them would be wasted work.
bool is_seen(const SheetPen& pen, const ImVec2& a, const ImVec2& b) {
    const Vec2d low = pen.camera.view_low, high = low + pen.camera.view_size;
    return std::max(a.x, b.x) >= float(low.x()) && std::min(a.x, b.x) <= float(high.x()) &&
           std::max(a.y, b.y) >= float(low.y()) && std::min(a.y, b.y) <= float(high.y());
}

// The part of a segment near the view, so that a segment of many thousand px has few dashes.
struct Part {
    float from = 0;
    float to = 0;
};
Part part_in_view(const SheetPen& pen, const ImVec2& a, const ImVec2& b) {
    const float length = distance(a, b);
    if (length < 4000) return {0, length};
    const Vec2d middle = pen.camera.view_low + pen.camera.view_size / 2;
    const ImVec2 along{(b.x - a.x) / length, (b.y - a.y) / length};
    const float nearest = (float(middle.x()) - a.x) * along.x + (float(middle.y()) - a.y) * along.y;
    const float reach = float(pen.camera.view_size.norm());
    return {std::clamp(nearest - reach, 0.0F, length), std::clamp(nearest + reach, 0.0F, length)};
}

}  // namespace

ImU32 packed(const render::Rgba8& colour) {
    return IM_COL32(colour[0], colour[1], colour[2], colour[3]);
}

render::Rgba8 faded(render::Rgba8 colour, double share) {
    colour[3] = static_cast<std::uint8_t>(std::lround(std::clamp(share, 0.0, 1.0) * colour[3]));
    return colour;
}

render::Rgba8 mixed(const render::Rgba8& from, const render::Rgba8& to, double share) {
    render::Rgba8 result{};
    for (std::size_t i = 0; i < 4; ++i) {
        result[i] = static_cast<std::uint8_t>(std::lround((1 - share) * from[i] + share * to[i]));
    }
    return result;
}

SheetColours dark_sheet_colours() {
    SheetColours dark;
    dark.paper = {0x25, 0x27, 0x2B, 0xFF};
    dark.fine_grid = {0x9F, 0xB4, 0xBE, 0x1E};
    dark.coarse_grid = {0x8A, 0xA4, 0xB0, 0x3A};
    dark.axis = {0x9F, 0xB8, 0xC4, 0x80};
    dark.ruler = {0x2F, 0x32, 0x36, 0xFF};
    dark.ruler_line = {0x4A, 0x4D, 0x53, 0xFF};
    dark.ruler_tick = {0x84, 0x86, 0x8A, 0xFF};
    dark.ruler_text = {0xB4, 0xB6, 0xB9, 0xFF};
    dark.ink = {0xEC, 0xEA, 0xE5, 0xFF};
    dark.faint_ink = {0xEC, 0xEA, 0xE5, 0x90};
    dark.locked = {0xEC, 0xEA, 0xE5, 0x60};
    dark.cut = {0xEC, 0xEA, 0xE5, 0xC0};
    dark.plain_cloth = {0x45, 0x48, 0x4D, 0xE8};
    dark.under_cloth = {0x33, 0x36, 0x3A, 0xFF};
    dark.cloth_strength = 0.5F;
    dark.plate = {0x2A, 0x2C, 0x30, 0xDC};
    dark.mirrored = {0xC0, 0xA6, 0xE2, 0xFF};
    dark.accent = {0x4F, 0xB0, 0xD0, 0xFF};
    dark.accent_fill = {0x4F, 0xB0, 0xD0, 0x2C};
    dark.hover = {0x4F, 0xB0, 0xD0, 0x80};
    dark.handle = {0x25, 0x27, 0x2B, 0xFF};
    dark.guide = {0xE5, 0x7F, 0xB4, 0xD8};
    dark.measure = {0xD6, 0xD8, 0xDB, 0xFF};
    dark.warning = {0xE5, 0xB1, 0x5A, 0xFF};
    dark.error = {0xF0, 0x72, 0x68, 0xFF};
    dark.pin = {0xF0, 0x72, 0x68, 0xFF};
    dark.bubble = {0xEC, 0xEA, 0xE5, 0xEB};
    dark.bubble_text = {0x26, 0x29, 0x2E, 0xFF};
    dark.bubble_problem = {0x9A, 0x50, 0x06, 0xFF};
    return dark;
}

ImVec2 SheetPen::px(const Vec2d& sheet) const {
    const Vec2d at = to_px(camera, sheet);
    return {static_cast<float>(at.x()), static_cast<float>(at.y())};
}

void SheetPen::line(std::span<const Vec2d> points, const render::Rgba8& colour, double width) const {
    const std::vector<ImVec2> drawn = in_px(*this, points);
    list.AddPolyline(drawn.data(), static_cast<int>(drawn.size()), packed(colour), 0, px(width));
}

void SheetPen::dashed(std::span<const Vec2d> points, const render::Rgba8& colour, double width, double dash) const {
    const std::vector<ImVec2> drawn = in_px(*this, points);
    const float step = px(dash);
    float left = step;  // px left of the current dash or gap
    bool is_on = true;
    for (std::size_t i = 0; i + 1 < drawn.size(); ++i) {
        const float length = distance(drawn[i], drawn[i + 1]);
        if (length <= 0) continue;
        if (!is_seen(*this, drawn[i], drawn[i + 1])) continue;
        const ImVec2 along{(drawn[i + 1].x - drawn[i].x) / length, (drawn[i + 1].y - drawn[i].y) / length};
        const Part part = part_in_view(*this, drawn[i], drawn[i + 1]);
        for (float at = part.from; at < part.to;) {
            const float end = std::min(part.to, at + left);
            const auto place = [&](float way) {
                return ImVec2(drawn[i].x + along.x * way, drawn[i].y + along.y * way);
            };
            if (is_on) list.AddLine(place(at), place(end), packed(colour), px(width));
            left -= end - at;
            at = end;
            if (left > 1e-3F) continue;
            left = step;
            is_on = !is_on;
        }
    }
}

void SheetPen::square(const Vec2d& at, double side, const render::Rgba8& inside, const render::Rgba8& rim) const {
    const ImVec2 middle = px(at);
    const float half = px(side / 2);
    const ImVec2 low{std::floor(middle.x - half) + 0.5F, std::floor(middle.y - half) + 0.5F};
    const ImVec2 high{low.x + std::round(2 * half), low.y + std::round(2 * half)};
    list.AddRectFilled(low, high, packed(inside), px(1));
    list.AddRect(low, high, packed(rim), px(1), 0, px(1.4));
}

void SheetPen::round(const Vec2d& at, double radius, const render::Rgba8& inside, const render::Rgba8& rim) const {
    list.AddCircleFilled(px(at), px(radius), packed(inside), 20);
    list.AddCircle(px(at), px(radius), packed(rim), 20, px(1.4));
}

LabelBox SheetPen::text_box(const Vec2d& at, const std::string& text, const ImVec2& px_offset, float size) const {
    const float height = std::round(ImGui::GetFontSize() * size);
    const ImVec2 room = ImGui::GetFont()->CalcTextSizeA(height, 1e6F, 0, text.c_str());
    const ImVec2 middle = px(at);
    const ImVec2 low{std::round(middle.x + px_offset.x - room.x / 2), std::round(middle.y + px_offset.y - room.y / 2)};
    return {{low.x - px(4), low.y - px(1)}, {low.x + room.x + px(4), low.y + room.y + px(1)}};
}

void SheetPen::text(const Vec2d& at, const std::string& text, const render::Rgba8& colour, const ImVec2& px_offset,
                    float size) const {
    const LabelBox box = text_box(at, text, px_offset, size);
    list.AddRectFilled(box.low, box.high, packed(colours.plate), px(3));
    list.AddText(ImGui::GetFont(), std::round(ImGui::GetFontSize() * size), {box.low.x + px(4), box.low.y + px(1)},
                 packed(colour), text.c_str());
}

double px_length(std::span<const ImVec2> line) {
    double length = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) length += distance(line[i], line[i + 1]);
    return length;
}

LinePoint place_on(std::span<const ImVec2> line, double length) {
    double left = length;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double part = distance(line[i], line[i + 1]);
        const bool is_last = i + 2 == line.size();
        if (part > 0 && (left <= part || is_last)) {
            const auto share = static_cast<float>(std::clamp(left / part, 0.0, 1.0));
            const ImVec2 way{line[i + 1].x - line[i].x, line[i + 1].y - line[i].y};
            const auto inverse = static_cast<float>(1 / part);
            return {{line[i].x + share * way.x, line[i].y + share * way.y}, {way.x * inverse, way.y * inverse}};
        }
        left -= part;
    }
    return {line.back(), {1, 0}};
}

void draw_direction(const SheetPen& pen, std::span<const ImVec2> line, const render::Rgba8& colour, double inward) {
    if (line.size() < 2) return;
    const double length = px_length(line);
    const double spacing = pen.px(44);
    if (length < pen.px(18)) return;
    const int ticks = std::clamp(static_cast<int>(length / spacing), 1, 24);
    const auto side = static_cast<float>(inward);
    for (int i = 1; i <= ticks; ++i) {
        const LinePoint place = place_on(line, length * i / (ticks + 1));
        const ImVec2 across{place.along.y * side, -place.along.x * side};  // px have y down
        const float reach = pen.px(5);
        pen.list.AddLine(place.at, {place.at.x + across.x * reach, place.at.y + across.y * reach}, packed(colour),
                         pen.px(1.4));
    }
    const LinePoint place = place_on(line, std::min<double>(pen.px(12), length / 3));
    const ImVec2 across{place.along.y, -place.along.x};
    const float back = pen.px(4.5), half = pen.px(4), ahead = pen.px(5.5);
    const ImVec2 base{place.at.x - place.along.x * back, place.at.y - place.along.y * back};
    const ImVec2 tip{place.at.x + place.along.x * ahead, place.at.y + place.along.y * ahead};
    pen.list.AddTriangleFilled({base.x + across.x * half, base.y + across.y * half}, tip,
                               {base.x - across.x * half, base.y - across.y * half}, packed(colour));
}

}  // namespace selvedge::editor
