#include "editor/tools/tool_host.h"

#include <cmath>

#include "editor/tools/draw_tools.h"
#include "editor/tools/outline_tools.h"
#include "editor/tools/panel_tools.h"
#include "editor/tools/select_tool.h"
#include "editor/tools/sewing_tools.h"

namespace selvedge::editor {
namespace {

constexpr double kDragThreshold = 3;    // px
constexpr double kGridStepAtLeast = 5;  // px
constexpr double kNudge = 0.001;        // m
constexpr double kLongNudge = 0.01;     // m

}  // namespace

ToolHost::ToolHost() : tool_(make_tool(ToolKind::Select)) {}

ToolContext ToolHost::context(ToolHostContext desk) {
    geometry_.update(desk.document.pattern(), desk.document.revision());
    return {.document = desk.document,
            .geometry = geometry_,
            .hover = desk.hover,
            .messages = desk.messages,
            .px = ui_scale_ / camera_.scale,
            .grid = grid_step(camera_, kGridStepAtLeast * ui_scale_),
            .is_snapping = is_snapping,
            .typed = typed_.numbers(),
            .pointer = pointer_};
}

// Runs an action; turns a GeometryError into a message that highlights the parts involved. Returns false in that case.
template <class Action>
bool ToolHost::guarded(ToolHostContext desk, Action&& action) {
    ToolContext given = context(desk);
    try {
        return action(given);
    } catch (const GeometryError& error) {
        const Message* shown = desk.messages.shown();
        if (shown == nullptr || shown->words != error.what()) desk.messages.error(error);  // once per drag
        return false;
    }
}

void ToolHost::choose(ToolHostContext desk, ToolKind kind) {
    cancel(desk);
    state_ = MouseState::Up;
    desk.messages.dismiss();
    kind_ = kind;
    tool_ = make_tool(kind);
    if (pointer_.at.allFinite()) guarded(desk, [&](ToolContext& given) { return tool_->hover(given, pointer_), true; });
}

void ToolHost::begin_frame(const Document& document, const SheetCamera& camera, double ui_scale) {
    camera_ = camera;
    ui_scale_ = ui_scale;
    geometry_.update(document.pattern(), document.revision());
}

void ToolHost::move(ToolHostContext desk, const Vec2d& px, const Modifiers& modifiers) {
    pointer_ = {to_sheet(camera_, px), modifiers};
    if (state_ == MouseState::Pressed && (px - pressed_px_).norm() > kDragThreshold * ui_scale_) {
        state_ = MouseState::Dragging;
    }
    guarded(desk, [&](ToolContext& given) {
        if (state_ == MouseState::Up) tool_->hover(given, pointer_);
        if (state_ == MouseState::Dragging) {
            const std::size_t said = desk.messages.count();
            tool_->drag(given, pointer_);
            if (desk.messages.count() == said) desk.messages.dismiss();  // no error now: hide the old message
        }
        return true;
    });
}

void ToolHost::press(ToolHostContext desk, const Vec2d& px, const Modifiers& modifiers) {
    desk.messages.dismiss();
    pointer_ = {to_sheet(camera_, px), modifiers};
    pressed_px_ = px;
    state_ = MouseState::Pressed;
    guarded(desk, [&](ToolContext& given) {
        tool_->hover(given, pointer_);
        tool_->press(given, pointer_);
        return true;
    });
}

void ToolHost::release(ToolHostContext desk, const Vec2d& px, const Modifiers& modifiers) {
    if (state_ == MouseState::Up) return;
    move(desk, px, modifiers);
    const bool was_dragged = state_ == MouseState::Dragging;
    state_ = MouseState::Up;
    guarded(desk, [&](ToolContext& given) {
        was_dragged ? tool_->drop(given, pointer_) : tool_->click(given, pointer_);
        return true;
    });
    guarded(desk, [&](ToolContext& given) { return tool_->hover(given, pointer_), true; });
}

void ToolHost::double_click(ToolHostContext desk, const Vec2d& px, const Modifiers& modifiers) {
    pointer_ = {to_sheet(camera_, px), modifiers};
    guarded(desk, [&](ToolContext& given) { return tool_->double_click(given, pointer_), true; });
}

void ToolHost::leave(ToolHostContext desk) {
    if (state_ == MouseState::Up) desk.hover = {};
}

bool ToolHost::run(ToolHostContext desk, const Command& command) {
    desk.messages.dismiss();
    return guarded(desk, [&](ToolContext& given) { return given.document.run(command), true; });
}

bool ToolHost::cancel(ToolHostContext desk) {
    const bool had_typed = !typed_.is_empty();
    typed_.clear();
    desk.messages.dismiss();
    if (state_ == MouseState::Dragging) state_ = MouseState::Up;
    if (desk.document.is_previewing()) desk.document.drop();
    return guarded(desk, [&](ToolContext& given) { return tool_->cancel(given); }) || had_typed;
}

bool ToolHost::text(ToolHostContext desk, std::string_view typed) {
    if (!typed_.add(typed)) return false;
    guarded(desk, [&](ToolContext& given) { return tool_->hover(given, pointer_), true; });
    return true;
}

bool ToolHost::key(ToolHostContext desk, Key key, const Modifiers& modifiers) {
    pointer_.modifiers = modifiers;
    return guarded(desk, [&](ToolContext&) { return key_unguarded(desk, key, modifiers); });
}

bool ToolHost::key_unguarded(ToolHostContext desk, Key key, const Modifiers& modifiers) {
    if (key == Key::Escape) {
        if (cancel(desk)) return true;
        if (!desk.document.selection().is_empty()) return desk.document.select({}), true;
        if (kind_ != ToolKind::Select) return choose(desk, ToolKind::Select), true;
        return false;
    }
    if (!typed_.is_empty()) {
        if (key == Key::Backspace) return typed_.remove_last(), true;
        if (key == Key::Enter || key == Key::KeypadEnter) {
            const std::optional<std::vector<double>> numbers = typed_.numbers();
            ToolContext given = context(desk);
            desk.messages.dismiss();
            if (!numbers) return desk.messages.warn("\"" + typed_.text() + "\" is no number"), true;
            typed_.clear();
            if (!tool_->enter(given, *numbers)) desk.messages.warn("There is nothing here that takes a number");
            return true;
        }
        if (key == key_of('X')) return true;  // arrives as text: 30 x 40
    }
    ToolContext given = context(desk);
    if (tool_->key(given, key, modifiers)) return true;
    if (key == Key::Delete || key == Key::Backspace) return remove_selected(desk);
    if (key >= Key::Right && key <= Key::Up) return nudge(desk, key, modifiers);
    if (modifiers.ctrl && !modifiers.alt && key == key_of('A')) return select_all(desk);
    if (modifiers.ctrl || modifiers.alt || modifiers.shift) return false;
    const std::optional<ToolKind> wanted = tool_of_key(key);
    if (!wanted) return false;
    choose(desk, *wanted);
    return true;
}

bool ToolHost::remove_selected(ToolHostContext desk) {
    const Selection& selected = desk.document.selection();
    RemoveParts remove;
    remove.panels.assign(selected.panels.begin(), selected.panels.end());
    const auto add = [&](const std::set<PartRef>& from, std::vector<PartRef>& to) {
        for (const PartRef& ref : from) {
            if (!selected.panels.contains(ref.panel)) to.push_back(ref);
        }
    };
    add(selected.vertices, remove.vertices);
    add(selected.internal_lines, remove.internal_lines);
    add(selected.notches, remove.notches);
    remove.seams.assign(selected.seams.begin(), selected.seams.end());
    const bool is_nothing = remove.panels.empty() && remove.vertices.empty() && remove.internal_lines.empty() &&
                            remove.notches.empty() && remove.seams.empty();
    if (is_nothing) return false;
    desk.messages.dismiss();
    desk.document.run(remove);
    return true;
}

bool ToolHost::nudge(ToolHostContext desk, Key key, const Modifiers& modifiers) {
    const double step = modifiers.shift ? kLongNudge : kNudge;
    Vec2d by(0, 0);
    if (key == Key::Right) by.x() = step;
    if (key == Key::Left) by.x() = -step;
    if (key == Key::Up) by.y() = step;
    if (key == Key::Down) by.y() = -step;
    const std::optional<Command> command = move_selected(geometry_, desk.document.selection(), by);
    if (!command) return false;
    desk.messages.dismiss();
    desk.document.run(*command);
    return true;
}

bool ToolHost::select_all(ToolHostContext desk) {
    Selection all;
    for (const PanelShape& shape : geometry_.panels()) all.panels.insert(shape.panel.name);
    desk.document.select(all);
    return true;
}

ToolOverlay ToolHost::overlay(ToolHostContext desk) {
    const ToolContext given = context(desk);
    ToolOverlay overlay;
    tool_->draw(given, overlay);
    return overlay;
}

std::string ToolHost::hint(ToolHostContext desk) {
    return tool_->hint(context(desk));
}

std::unique_ptr<Tool> make_tool(ToolKind kind) {
    switch (kind) {
        case ToolKind::Select:
            return std::make_unique<SelectTool>();
        case ToolKind::EditPoint:
            return std::make_unique<EditPointTool>();
        case ToolKind::AddPoint:
            return std::make_unique<AddPointTool>();
        case ToolKind::CurvePoint:
            return std::make_unique<CurveTool>();
        case ToolKind::Polygon:
            return std::make_unique<PolygonTool>();
        case ToolKind::Rectangle:
            return std::make_unique<BoxTool>(BoxShape::Rectangle);
        case ToolKind::Ellipse:
            return std::make_unique<BoxTool>(BoxShape::Ellipse);
        case ToolKind::InternalLine:
            return std::make_unique<InternalLineTool>();
        case ToolKind::Dart:
            return std::make_unique<DartTool>();
        case ToolKind::Notch:
            return std::make_unique<NotchTool>();
        case ToolKind::Rotate:
            return std::make_unique<TransformTool>(TransformMode::Rotate);
        case ToolKind::Scale:
            return std::make_unique<TransformTool>(TransformMode::Scale);
        case ToolKind::Mirror:
            return std::make_unique<MirrorTool>();
        case ToolKind::Cut:
            return std::make_unique<CutTool>();
        case ToolKind::Merge:
            return std::make_unique<MergeTool>();
        case ToolKind::Unfold:
            return std::make_unique<UnfoldTool>();
        case ToolKind::Measure:
            return std::make_unique<MeasureTool>();
        case ToolKind::SegmentSewing:
            return std::make_unique<SewingTool>();
        case ToolKind::FreeSewing:
            return std::make_unique<FreeSewingTool>();
    }
    return std::make_unique<SelectTool>();
}

}  // namespace selvedge::editor
