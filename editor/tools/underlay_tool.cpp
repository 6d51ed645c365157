#include "editor/tools/underlay_tool.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "editor/geometry/draft.h"

namespace selvedge::editor {
namespace {

constexpr double kCm = 0.01;
constexpr double kLeastApart = 4;  // px: points closer than this give no scale

const ToolInfo kUnderlayTool{.id = "fit_photo",
                             .title = "Fit photo",
                             .what = "Click two points of the photo and type how far apart they are",
                             .make = make<UnderlayTool>,
                             .icon = "M2 3 L14 3 L14 13 L2 13 Z M4 10 L12 6 D4 10 1.3 D12 6 1.3"};

// To the nearest quarter turn, of a line at that angle.
double turn_to_axis(double angle) {
    constexpr double kQuarter = std::numbers::pi / 2;
    return std::round(angle / kQuarter) * kQuarter - angle;
}

}  // namespace

sim::Underlay fitted(sim::Underlay underlay, const Vec2d& about, double scale, double angle) {
    underlay.position = about + scale * (Eigen::Rotation2Dd(angle) * (underlay.position - about));
    underlay.pixel_size *= scale;
    underlay.rotation += angle;
    return underlay;
}

std::array<Vec2d, 4> underlay_corners(const sim::Underlay& underlay, int width_px, int height_px) {
    const Vec2d half = underlay.pixel_size * Vec2d(width_px, height_px) / 2;
    const Eigen::Rotation2Dd turned(underlay.rotation);
    std::array<Vec2d, 4> corners{Vec2d(-half.x(), half.y()), half, Vec2d(half.x(), -half.y()), -half};
    for (Vec2d& corner : corners) corner = underlay.position + turned * corner;
    return corners;
}

SheetBox extended(SheetBox box, const std::vector<sim::Underlay>& underlays,
                  const std::function<Eigen::Vector2i(const std::string& file)>& size_px) {
    for (const sim::Underlay& underlay : underlays) {
        const Eigen::Vector2i size = size_px(underlay.file);
        for (const Vec2d& corner : underlay_corners(underlay, size.x(), size.y())) box.extend(corner);
    }
    return box;
}

std::optional<std::size_t> UnderlayTool::chosen(const ToolContext& context) const {
    const std::size_t count = context.document.pattern().underlays.size();
    if (count == 0) return std::nullopt;
    return count - 1 - passed_ % count;
}

void UnderlayTool::hover(ToolContext&, const SheetPointer& pointer) {
    at_ = pointer.at;
}

void UnderlayTool::press(ToolContext&, const SheetPointer& pointer) {
    grip_ = pointer.at;
}

void UnderlayTool::click(ToolContext&, const SheetPointer& pointer) {
    if (points_.size() == 2) points_.clear();
    points_.push_back(pointer.at);
}

// Rolls the preview back first: the photo is then where it was before the drag.
void UnderlayTool::drag(ToolContext& context, const SheetPointer& pointer) {
    context.document.rollback();
    const std::optional<std::size_t> index = chosen(context);
    if (!index) return;
    sim::Underlay moved = context.document.pattern().underlays[*index];
    moved.position += pointer.at - grip_;
    context.document.preview(set_underlay(context.document.pattern(), *index, moved, "Move photo"));
}

void UnderlayTool::drop(ToolContext& context, const SheetPointer& pointer) {
    drag(context, pointer);
    context.document.commit();
    for (Vec2d& point : points_) point += pointer.at - grip_;
}

bool UnderlayTool::key(ToolContext& context, Key key, const Modifiers& modifiers) {
    if (modifiers.ctrl || !chosen(context)) return false;
    if (key == Key::Tab) return ++passed_, points_.clear(), true;
    if (key != key_of('L') || points_.size() != 2) return false;
    const Vec2d way = points_[1] - points_[0];
    fit(context, 1, turn_to_axis(std::atan2(way.y(), way.x())), "Turn photo");
    return true;
}

bool UnderlayTool::enter(ToolContext& context, const std::vector<double>& numbers) {
    if (!chosen(context) || points_.size() != 2) return false;
    const double distance = kCm * numbers.front(), shown = (points_[1] - points_[0]).norm();
    if (!(distance > 0)) throw GeometryError("The distance between the two points is more than 0 cm");
    if (shown < kLeastApart * context.px) throw GeometryError("The two points are too close to each other for a scale");
    fit(context, distance / shown, 0, "Scale photo");
    return true;
}

void UnderlayTool::fit(ToolContext& context, double scale, double angle, const std::string& what) {
    const sim::Pattern& pattern = context.document.pattern();
    const std::size_t index = chosen(context).value();
    context.document.run(
        set_underlay(pattern, index, fitted(pattern.underlays[index], points_[0], scale, angle), what));
    points_[1] = points_[0] + scale * (Eigen::Rotation2Dd(angle) * (points_[1] - points_[0]));
}

bool UnderlayTool::cancel(ToolContext& context) {
    const bool was_begun = !points_.empty() || context.document.is_previewing();
    context.document.rollback();
    points_.clear();
    return was_begun;
}

void UnderlayTool::draw(const ToolContext& context, ToolOverlay& overlay) const {
    for (const Vec2d& point : points_)
        overlay.handles.push_back({point, HandleShape::Cross, OverlayTone::Measure, false});
    if (points_.empty()) return;
    const Vec2d end = points_.size() == 2 ? points_[1] : at_;
    overlay.lines.push_back({.points = {points_[0], end}, .tone = OverlayTone::Measure});
    if (points_.size() < 2) return;
    std::string text = in_cm((end - points_[0]).norm());
    if (context.typed && !context.typed->empty()) text += " will be " + in_cm(kCm * context.typed->front());
    overlay.labels.push_back({.at = (points_[0] + end) / 2, .text = text});
}

std::string UnderlayTool::hint(const ToolContext& context) const {
    if (!chosen(context)) return "There is no photo under the sheet: lay one there by File, Import";
    if (points_.empty()) return "Click two points of the photo whose distance you know; drag to move it";
    if (points_.size() == 1) return "Click the second point";
    return "Type their true distance in cm, then Enter; L turns the photo until the line is level or upright";
}

const ToolInfo& underlay_tool() {
    return kUnderlayTool;
}

}  // namespace selvedge::editor
