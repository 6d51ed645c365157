#include "editor/tools/transform_tool.h"

#include <cmath>
#include <cstdio>
#include <numbers>

#include "editor/drafting/draft_error.h"
#include "editor/tools/overlay_parts.h"
#include "editor/tools/select_tool.h"
#include "editor/tools/selected_parts.h"

namespace selvedge {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

Vec2d handle_place(const SheetBox& box, const Vec2d& handle) {
    return box.center() + handle.cwiseProduct(box.sizes() / 2);
}

template <class Use>
void for_each_handle(Use&& use) {
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            if (x != 0 || y != 0) use(Vec2d(x, y));
        }
    }
}

std::string in_percent(double factor) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f %%", factor * 100);
    return text;
}

}  // namespace

void TransformTool::press(ToolContext& context, const SheetPointer& pointer) {
    pressed_ = pick(context.geometry, pointer.at, pick_options(context));
    held_ = context.document.selection();
    box_ = context.geometry.box_of(held_);
    pressed_at_ = pointer.at;
    handle_.reset();
    is_dragging_ = false;
    if (box_.isEmpty()) return;
    for_each_handle([&](const Vec2d& handle) {
        if ((handle_place(box_, handle) - pointer.at).norm() <= 1.3 * kPickTolerance * context.px) handle_ = handle;
    });
}

void TransformTool::click(ToolContext& context, const SheetPointer& pointer) {
    if (!handle_) context.document.select(with_picked(held_, pressed_, pointer.modifiers.shift));
}

void TransformTool::drag(ToolContext& context, const SheetPointer& pointer) {
    if (box_.isEmpty()) {  // nothing was selected: take what was pressed
        if (pressed_.kind == PickKind::Nothing) return;
        context.document.select(with_picked({}, pressed_, false));
        held_ = context.document.selection();
        box_ = context.geometry.box_of(held_);
        if (box_.isEmpty()) return;
    }
    is_dragging_ = true;
    mode_ == TransformMode::Rotate ? rotate(context, pointer) : scale(context, pointer);
}

void TransformTool::rotate(ToolContext& context, const SheetPointer& pointer) {
    const Vec2d centre = box_.center(), from = pressed_at_ - centre, to = pointer.at - centre;
    if (from.norm() == 0 || to.norm() == 0) return;
    angle_ = std::atan2(cross2(from, to), from.dot(to));
    const double step = pointer.modifiers.shift ? 15 * kDegree : kDegree;
    if (pointer.modifiers.shift || snap_options(context, pointer.modifiers).is_on) {
        angle_ = std::round(angle_ / step) * step;
    }
    attempt(context, rotation_about(centre, angle_));
}

// About the opposite handle, with Alt about the middle. A handle that stands in the middle of a side scales one way.
void TransformTool::scale(ToolContext& context, const SheetPointer& pointer) {
    if (!handle_) return;
    const bool is_about_middle = pointer.modifiers.alt;
    const Vec2d fixed = is_about_middle ? Vec2d(box_.center()) : handle_place(box_, -*handle_);
    const Vec2d held = handle_place(box_, *handle_);
    SnapOptions options = snap_options(context, pointer.modifiers);
    options.to_directions = false;
    options.moving_panels = touched_panels(held_);
    const Vec2d to = snap(context.geometry, pointer.at, options).point;
    factors_ = Vec2d(1, 1);
    for (int axis = 0; axis < 2; ++axis) {
        const double before = held[axis] - fixed[axis];
        if ((*handle_)[axis] != 0 && std::abs(before) > 1e-9) factors_[axis] = (to[axis] - fixed[axis]) / before;
    }
    if (pointer.modifiers.shift) {
        const bool is_x =
            (*handle_).x() != 0 && ((*handle_).y() == 0 || std::abs(factors_.x() - 1) > std::abs(factors_.y() - 1));
        factors_ = Vec2d::Constant(is_x ? factors_.x() : factors_.y());
    }
    if (factors_.cwiseAbs().minCoeff() < 0.01) return;
    attempt(context, scaling_about(fixed, factors_));
}

void TransformTool::attempt(ToolContext& context, const PlaneMap& map) {
    const char* what = mode_ == TransformMode::Rotate ? "Rotate" : "Scale";
    if (const std::optional<Command> command = transform_selected(context.geometry, held_, map, what)) {
        context.document.attempt(*command);
    }
}

void TransformTool::drop(ToolContext& context, const SheetPointer&) {
    is_dragging_ = false;
    context.document.keep();
}

bool TransformTool::enter(ToolContext& context, const std::vector<double>& numbers) {
    const Selection& selection = context.document.selection();
    const SheetBox box = context.geometry.box_of(selection);
    if (box.isEmpty()) throw DraftError("Select first what is to be changed");
    PlaneMap map;
    if (mode_ == TransformMode::Rotate) {
        if (numbers.size() != 1) return false;
        map = rotation_about(box.center(), numbers[0] * kDegree);
    } else {
        if (numbers.size() > 2) return false;
        const Vec2d factors(numbers.front(), numbers.back());
        if (factors.cwiseAbs().minCoeff() < 0.01)
            throw DraftError("A factor of nothing leaves nothing: type such as 1.05");
        map = scaling_about(box.center(), factors);
    }
    const char* what = mode_ == TransformMode::Rotate ? "Rotate" : "Scale";
    const std::optional<Command> command = transform_selected(context.geometry, selection, map, what);
    if (!command) return false;
    context.document.run(*command);
    return true;
}

bool TransformTool::cancel(ToolContext&) {
    const bool was_dragging = is_dragging_;
    is_dragging_ = false;
    return was_dragging;
}

void TransformTool::draw(const ToolContext& context, ToolOverlay& overlay) const {
    const SheetBox box = context.geometry.box_of(context.document.selection());
    if (box.isEmpty()) return;
    add_box(overlay, box, OverlayTone::Faint);
    const HandleShape shape = mode_ == TransformMode::Rotate ? HandleShape::Round : HandleShape::Square;
    for_each_handle([&](const Vec2d& handle) {
        const bool is_corner = handle.x() != 0 && handle.y() != 0;
        if (mode_ == TransformMode::Rotate && !is_corner) return;
        overlay.handles.push_back({handle_place(box, handle), shape, OverlayTone::Draft, false});
    });
    if (mode_ == TransformMode::Rotate)
        overlay.handles.push_back({box.center(), HandleShape::Cross, OverlayTone::Draft, false});
    if (!is_dragging_) return;
    if (mode_ == TransformMode::Rotate) {
        overlay.lines.push_back(
            {.points = {box_.center(), context.pointer.at}, .tone = OverlayTone::Measure, .is_dashed = true});
        overlay.readout = {in_degrees(angle_)};
    } else {
        overlay.readout = {in_percent(factors_.x()) + " x " + in_percent(factors_.y()),
                           in_cm(box.sizes().x()) + " x " + in_cm(box.sizes().y())};
    }
}

std::string TransformTool::hint(const ToolContext& context) const {
    if (context.document.selection().is_empty()) return "Click what is to be changed";
    if (mode_ == TransformMode::Rotate) return "Drag to turn, Shift: by 15\u00b0; or type degrees, then Enter";
    return "Drag a handle, Shift: both ways alike, Alt: about the middle; or type a factor, such as 1.05 or 1.1 x 1";
}

}  // namespace selvedge
