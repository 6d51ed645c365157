#include "editor/tools/tool.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "editor/geometry/expression.h"
#include "editor/tools/sheet_pick.h"

namespace selvedge::editor {
namespace {

std::string rounded(double value, const char* unit) {
    char text[48];
    std::snprintf(text, sizeof text, "%.2f", value);
    std::string number = text;
    if (number.ends_with("0")) number.pop_back();
    if (number == "-0.0") number = "0.0";
    return number + " " + unit;
}

}  // namespace

SnapOptions snap_options(const ToolContext& context, const Modifiers& modifiers) {
    SnapOptions options;
    options.is_on = context.is_snapping && !modifiers.ctrl;
    options.tolerance = kSnapTolerance * context.px;
    options.grid = context.grid;
    options.to_directions = modifiers.shift;
    return options;
}

PickOptions pick_options(const ToolContext& context) {
    PickOptions options;
    options.tolerance = kPickTolerance * context.px;
    return options;
}

void Tool::hover(ToolContext& context, const SheetPointer& pointer) {
    context.hover = hover_of(context.geometry, pick(context.geometry, pointer.at, pick_options(context)));
}

std::string in_cm(double metres) {
    return rounded(metres * 100, "cm");
}

std::string in_mm(double metres) {
    char text[48];
    std::snprintf(text, sizeof text, "%+.1f mm", metres * 1000);
    return text;
}

std::string in_degrees(double radians) {
    char text[48];
    std::snprintf(text, sizeof text, "%.1f\u00b0", radians * 180 / std::numbers::pi);
    return text;
}

namespace {

constexpr std::size_t kMaxLength = 64;
constexpr std::string_view kBegins = "0123456789.,-(";
constexpr std::string_view kGoesOn = "0123456789.,-+*/() xX<";

}  // namespace

bool TypedInput::add(std::string_view text) {
    bool is_taken = false;
    for (const char c : text) {
        const std::string_view known = text_.empty() ? kBegins : kGoesOn;
        if (known.find(c) == std::string_view::npos || text_.size() >= kMaxLength) continue;
        text_ += c == 'X' ? 'x' : c;
        is_taken = true;
    }
    return is_taken;
}

void TypedInput::remove_last() {
    if (!text_.empty()) text_.pop_back();
}

std::optional<std::vector<double>> TypedInput::numbers() const {
    if (text_.empty()) return {};
    if (const std::size_t angle = text_.find('<'); angle != std::string::npos) return polar(angle);
    std::vector<double> numbers;
    std::string_view rest = text_;
    while (true) {
        const std::size_t cross = rest.find('x');
        const std::optional<double> number = evaluate(rest.substr(0, cross));
        if (!number) return {};
        numbers.push_back(*number);
        if (cross == std::string_view::npos) return numbers;
        rest.remove_prefix(cross + 1);
    }
}

// "12 < 30": 12 in the direction of 30 degrees, counter-clockwise from the right, as across x up.
std::optional<std::vector<double>> TypedInput::polar(std::size_t sign) const {
    const std::string_view whole = text_;
    const std::optional<double> length = evaluate(whole.substr(0, sign)), degrees = evaluate(whole.substr(sign + 1));
    if (!length || !degrees) return {};
    const double angle = *degrees * std::numbers::pi / 180;
    return std::vector<double>{*length * std::cos(angle), *length * std::sin(angle)};
}

void add_guides(ToolOverlay& overlay, const Snap& snapped) {
    for (const SnapGuide& guide : snapped.guides) {
        overlay.lines.push_back({.points = {guide.from, guide.to}, .tone = OverlayTone::Guide, .is_dashed = true});
        overlay.handles.push_back({guide.from, HandleShape::Cross, OverlayTone::Guide, false});
    }
    if (snapped.kind == SnapKind::Point) {
        overlay.handles.push_back({snapped.point, HandleShape::Round, OverlayTone::Guide, false});
    }
    if (snapped.kind == SnapKind::Midpoint) {
        overlay.handles.push_back({snapped.point, HandleShape::Diamond, OverlayTone::Guide, false});
    }
}

std::vector<Vec2d> part_of_edge(const PanelShape& shape, int edge, double from, double to) {
    const EdgeShape& line = shape.edges.at(static_cast<std::size_t>(edge));
    const double low = std::min(from, to), high = std::max(from, to);
    std::vector<Vec2d> points{shape.on_sheet(line.at(low))};
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const bool is_between = line.reached[i] > low * line.length && line.reached[i] < high * line.length;
        if (is_between) points.push_back(shape.on_sheet(line.points[i]));
    }
    points.push_back(shape.on_sheet(line.at(high)));
    if (from > to) std::reverse(points.begin(), points.end());
    return points;
}

void add_edge(ToolOverlay& overlay, const SheetGeometry& geometry, const PartRef& edge, OverlayTone tone) {
    const PanelShape* shape = geometry.find(edge.panel);
    if (shape == nullptr || geometry.edge(edge) == nullptr) return;
    overlay.lines.push_back({.points = part_of_edge(*shape, edge.index, 0, 1), .tone = tone});
}

void add_box(ToolOverlay& overlay, const SheetBox& box, OverlayTone tone) {
    if (box.isEmpty()) return;
    const Vec2d &low = box.min(), &high = box.max();
    overlay.lines.push_back({.points = {low, Vec2d(high.x(), low.y()), high, Vec2d(low.x(), high.y()), low},
                             .tone = tone,
                             .is_closed = true});
}

std::set<PartRef> curved_edges_of(const SheetGeometry& geometry, const std::set<std::string>& panels) {
    std::set<PartRef> edges;
    for (const std::string& name : panels) {
        const PanelShape* shape = geometry.find(name);
        if (shape == nullptr) continue;
        for (std::size_t i = 0; i < shape->panel.edges.size(); ++i) {
            if (control_count(shape->panel.edges[i].kind) > 0) edges.insert({name, static_cast<int>(i)});
        }
    }
    return edges;
}

}  // namespace selvedge::editor
