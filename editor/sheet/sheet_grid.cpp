#include "editor/sheet/sheet_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace selvedge {
namespace {

constexpr std::array<double, 6> kSteps{0.001, 0.01, 0.05, 0.10, 0.50, 1.0};  // m
constexpr double kSeenFrom = 5;                                              // px between lines: faint
constexpr double kFullFrom = 14;                                             // px: as strong as they get
constexpr double kCoarseFrom = 45;                                           // px: lines that stand out
constexpr double kLabelsApart = 52;                                          // px

struct Range {
    long first = 0;
    long last = 0;
};

Range lines_in(double low, double high, double step) {
    return {static_cast<long>(std::ceil(low / step)), static_cast<long>(std::floor(high / step))};
}

float crisp(double at) {
    return static_cast<float>(std::floor(at) + 0.5);
}

// Lines of one step, but for those that the next one draws.
void draw_lines(const SheetPen& pen, double step, double next, const Rgba8& colour) {
    const SheetBox box = visible_box(pen.camera);
    const Vec2d low = pen.camera.view_low, high = low + pen.camera.view_size;
    const long per_next = std::lround(next / step);
    for (int axis = 0; axis < 2; ++axis) {
        const Range range = lines_in(box.min()[axis], box.max()[axis], step);
        for (long i = range.first; i <= range.last; ++i) {
            if (per_next > 1 && i % per_next == 0) continue;
            const Vec2d at = to_px(pen.camera, Vec2d::Constant(double(i) * step));
            const Rgba8& drawn = i == 0 ? pen.colours.axis : colour;
            if (axis == 0) {
                pen.list.AddRectFilled({crisp(at.x()) - 0.5F, float(low.y())}, {crisp(at.x()) + 0.5F, float(high.y())},
                                       packed(drawn));
            } else {
                pen.list.AddRectFilled({float(low.x()), crisp(at.y()) - 0.5F}, {float(high.x()), crisp(at.y()) + 0.5F},
                                       packed(drawn));
            }
        }
    }
}

double label_step(const SheetPen& pen) {
    for (const double step : {0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0}) {
        if (step * pen.camera.scale >= double(pen.px(kLabelsApart))) return step;
    }
    return 10;
}

std::string label(double metres, double step) {
    char text[32];
    std::snprintf(text, sizeof text, step < 0.01 ? "%.1f" : "%.0f", metres * 100);
    return text[0] == '-' && std::string(text).find_first_not_of("-0.") == std::string::npos ? text + 1 : text;
}

void draw_ticks(const SheetPen& pen, int axis) {
    const SheetBox box = visible_box(pen.camera);
    const Vec2d low = pen.camera.view_low;
    const float width = pen.px(kRulerWidth);
    const double labelled = label_step(pen);
    const double step = labelled / (labelled * pen.camera.scale >= double(pen.px(100)) ? 10 : 5);
    const Range range = lines_in(box.min()[axis], box.max()[axis], step);
    const long per_label = std::lround(labelled / step);
    for (long i = range.first; i <= range.last; ++i) {
        const Vec2d at = to_px(pen.camera, Vec2d::Constant(double(i) * step));
        const bool has_label = i % per_label == 0;
        const bool is_half = per_label % 2 == 0 && i % (per_label / 2) == 0;
        const float length = pen.px(has_label ? 9 : is_half ? 6 : 4);
        const float along = crisp(axis == 0 ? at.x() : at.y());
        if (along < float(low[axis]) + width) continue;
        const std::string text = has_label ? label(double(i) * step, labelled) : "";
        const float size = pen.px(11);
        ImFont* font = ImGui::GetFont();
        if (axis == 0) {
            const float base = float(low.y()) + width;
            pen.list.AddLine({along, base}, {along, base - length}, packed(pen.colours.ruler_tick));
            if (has_label)
                pen.list.AddText(font, size, {along + pen.px(3), float(low.y()) + pen.px(2)},
                                 packed(pen.colours.ruler_text), text.c_str());
        } else {
            const float base = float(low.x()) + width;
            pen.list.AddLine({base, along}, {base - length, along}, packed(pen.colours.ruler_tick));
            if (has_label)
                pen.list.AddText(font, size, {float(low.x()) + pen.px(2), along + pen.px(1)},
                                 packed(pen.colours.ruler_text), text.c_str());
        }
    }
}

}  // namespace

void draw_grid(const SheetPen& pen) {
    const Vec2d low = pen.camera.view_low, high = low + pen.camera.view_size;
    pen.list.AddRectFilled({float(low.x()), float(low.y())}, {float(high.x()), float(high.y())},
                           packed(pen.colours.paper));
    for (std::size_t i = 0; i < kSteps.size(); ++i) {
        const double apart = kSteps[i] * pen.camera.scale / double(pen.ui);
        if (apart < kSeenFrom) continue;
        const double next = i + 1 < kSteps.size() ? kSteps[i + 1] : kSteps[i];
        const double seen = std::clamp((apart - kSeenFrom) / (kFullFrom - kSeenFrom), 0.0, 1.0);
        const double coarse = std::clamp((apart - kCoarseFrom / 2) / (kCoarseFrom / 2), 0.0, 1.0);
        const Rgba8 fine = faded(pen.colours.fine_grid, seen);
        draw_lines(pen, kSteps[i], next, mixed(fine, pen.colours.coarse_grid, coarse));
    }
}

void draw_rulers(const SheetPen& pen, const std::optional<Vec2d>& cursor) {
    const Vec2d low = pen.camera.view_low, high = low + pen.camera.view_size;
    const float width = pen.px(kRulerWidth);
    const ImVec2 corner{float(low.x()), float(low.y())}, end{float(high.x()), float(high.y())};
    pen.list.AddRectFilled(corner, {end.x, corner.y + width}, packed(pen.colours.ruler));
    pen.list.AddRectFilled(corner, {corner.x + width, end.y}, packed(pen.colours.ruler));
    for (const int axis : {0, 1}) draw_ticks(pen, axis);
    pen.list.AddLine({corner.x, corner.y + width}, {end.x, corner.y + width}, packed(pen.colours.ruler_line));
    pen.list.AddLine({corner.x + width, corner.y}, {corner.x + width, end.y}, packed(pen.colours.ruler_line));
    pen.list.AddRectFilled(corner, {corner.x + width, corner.y + width}, packed(pen.colours.ruler));
    pen.list.AddText(ImGui::GetFont(), pen.px(11), {corner.x + pen.px(4), corner.y + pen.px(5)},
                     packed(pen.colours.ruler_text), "cm");
    if (!cursor) return;
    const float x = crisp(cursor->x()), y = crisp(cursor->y()), half = pen.px(3.5);
    if (x > corner.x + width) {
        pen.list.AddTriangleFilled({x - half, corner.y + width - pen.px(6)}, {x + half, corner.y + width - pen.px(6)},
                                   {x, corner.y + width}, packed(pen.colours.accent));
    }
    if (y > corner.y + width) {
        pen.list.AddTriangleFilled({corner.x + width - pen.px(6), y - half}, {corner.x + width, y},
                                   {corner.x + width - pen.px(6), y + half}, packed(pen.colours.accent));
    }
}

}  // namespace selvedge
