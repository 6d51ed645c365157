#include "editor/sheet/sheet_labels.h"

#include <algorithm>
#include <array>
#include <limits>

#include "editor/frame/item.h"

namespace selvedge::editor {
namespace {

float overlap(const LabelBox& a, const LabelBox& b) {
    const float width = std::min(a.high.x, b.high.x) - std::max(a.low.x, b.low.x);
    const float height = std::min(a.high.y, b.high.y) - std::max(a.low.y, b.low.y);
    return std::max(0.0F, width) * std::max(0.0F, height);
}

LabelBox box_around(const ImVec2& centre, const ImVec2& size) {
    return {{centre.x - size.x / 2, centre.y - size.y / 2}, {centre.x + size.x / 2, centre.y + size.y / 2}};
}

// Position of the panel's name: the centroid, or, if that lies outside, the centroid of the largest triangle.
Vec2d middle_of(const PanelShape& shape, const PanelFace& face) {
    Vec2d sum(0, 0), largest = shape.box.center();
    double area = 0, best = 0;
    for (const auto& [a, b, c] : face.triangles) {
        const Vec2d &p = face.points[std::size_t(a)], &q = face.points[std::size_t(b)],
                    &r = face.points[std::size_t(c)];
        const double part = sim::cross2(q - p, r - p) / 2;
        const Vec2d centre = (p + q + r) / 3;
        sum += part * centre;
        area += part;
        if (part > best) largest = centre;
        best = std::max(best, part);
    }
    const Vec2d middle = area > 0 ? Vec2d(sum / area) : shape.box.center();
    return shape.contains(middle) ? middle : largest;
}

}  // namespace

ImVec2 LabelPlaces::place(const ImVec2& size, std::span<const ImVec2> centres) {
    ImVec2 best = centres.front();
    float least = std::numeric_limits<float>::max();
    for (const ImVec2& centre : centres) {
        float covered = 0;
        for (const LabelBox& box : taken_) covered += overlap(box, box_around(centre, size));
        if (covered >= least) continue;
        least = covered;
        best = centre;
    }
    reserve(box_around(best, size));
    return best;
}

PanelName name_of(const SheetLook& look, const PanelShape& shape) {
    const SheetPen& pen = look.pen;
    const Vec2d size_px = shape.box.sizes() * pen.camera.scale / double(pen.ui);
    constexpr double kSmallestPanel = 34;  // px
    if (size_px.minCoeff() < kSmallestPanel) return {.panel = shape.panel.name};
    constexpr double kMargin = 56, kSmallestMargin = 24;  // px, for the seams on both sides
    const std::string& name = shape.panel.name;
    const double width = double(ImGui::CalcTextSize(name.c_str()).x) / double(pen.ui);
    const double share = std::clamp(size_px.x() / (width + kMargin), kSmallestName, 1.0);
    PanelName result{.panel = name,
                     .has_room = true,
                     .middle = middle_of(shape, look.faces.face(shape, pen.camera.scale)),
                     .size = static_cast<float>(share)};
    const double room = (size_px.x() - kSmallestMargin) / share;
    const std::string shown = elided(name, pen.px(std::max(0.0, room)));
    constexpr std::size_t kFewestBytes = 5;  // two letters and the dots
    if (shown != name && shown.size() < kFewestBytes) return result;
    result.shown = shown;
    result.box = pen.text_box(shape.on_sheet(result.middle), shown, {0, 0}, result.size);
    return result;
}

}  // namespace selvedge::editor
