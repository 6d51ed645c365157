#include "editor/tools/tool_host.h"

#include <cmath>

#include "editor/tools/selected_parts.h"

namespace selvedge {
namespace {

constexpr double kDragThreshold = 3;      // px
constexpr double kGridStepAtLeast = 5;    // px
constexpr double kNudge = 0.001;          // m
constexpr double kLongNudge = 0.01;       // m

}  // namespace

ToolHost::ToolHost() : tool_(make_tool(ToolKind::Select)) {}

ToolContext ToolHost::context(Document& document) {
    geometry_.update(document.pattern(), document.revision());
    return {.document = document,
            .geometry = geometry_,
            .hover = hover_,
            .message = message_,
            .px = ui_scale_ / camera_.scale,
            .grid = grid_step(camera_, kGridStepAtLeast * ui_scale_),
            .is_snapping = is_snapping,
            .typed = typed_.numbers(),
            .pointer = pointer_};
}

// A draft that cannot be is said, lit up, and taken back.
template <class Action>
bool ToolHost::guarded(Document& document, Action&& action) {
    ToolContext given = context(document);
    try {
        return action(given);
    } catch (const DraftError& error) {
        message_ = error.what();
        is_error_ = true;
        lit_places_ = error.places();
        return false;
    }
}

void ToolHost::clear_message() {
    message_.clear();
    is_error_ = false;
    lit_places_.clear();
}

void ToolHost::choose(Document& document, ToolKind kind) {
    cancel(document);
    state_ = MouseState::Up;
    clear_message();
    kind_ = kind;
    tool_ = make_tool(kind);
    if (pointer_.at.allFinite()) guarded(document, [&](ToolContext& given) { return tool_->hover(given, pointer_), true; });
}

void ToolHost::begin_frame(const Document& document, const SheetCamera& camera, double ui_scale) {
    camera_ = camera;
    ui_scale_ = ui_scale;
    geometry_.update(document.pattern(), document.revision());
}

void ToolHost::move(Document& document, const Vec2d& px, const Modifiers& modifiers) {
    pointer_ = {to_sheet(camera_, px), modifiers};
    if (state_ == MouseState::Pressed && (px - pressed_px_).norm() > kDragThreshold * ui_scale_) {
        state_ = MouseState::Dragging;
    }
    guarded(document, [&](ToolContext& given) {
        if (state_ == MouseState::Up) tool_->hover(given, pointer_);
        if (state_ == MouseState::Dragging) {
            if (is_error_) clear_message();  // what was wrong a moment ago may be right now
            tool_->drag(given, pointer_);
        }
        return true;
    });
}

void ToolHost::press(Document& document, const Vec2d& px, const Modifiers& modifiers) {
    clear_message();
    pointer_ = {to_sheet(camera_, px), modifiers};
    pressed_px_ = px;
    state_ = MouseState::Pressed;
    guarded(document, [&](ToolContext& given) {
        tool_->hover(given, pointer_);
        tool_->press(given, pointer_);
        return true;
    });
}

void ToolHost::release(Document& document, const Vec2d& px, const Modifiers& modifiers) {
    if (state_ == MouseState::Up) return;
    move(document, px, modifiers);
    const bool was_dragged = state_ == MouseState::Dragging;
    state_ = MouseState::Up;
    guarded(document, [&](ToolContext& given) {
        was_dragged ? tool_->drop(given, pointer_) : tool_->click(given, pointer_);
        return true;
    });
    guarded(document, [&](ToolContext& given) { return tool_->hover(given, pointer_), true; });
}

void ToolHost::double_click(Document& document, const Vec2d& px, const Modifiers& modifiers) {
    pointer_ = {to_sheet(camera_, px), modifiers};
    guarded(document, [&](ToolContext& given) { return tool_->double_click(given, pointer_), true; });
}

void ToolHost::leave() {
    if (state_ == MouseState::Up) hover_ = {};
}

bool ToolHost::run(Document& document, const Command& command) {
    clear_message();
    return guarded(document, [&](ToolContext& given) { return given.document.run(command), true; });
}

bool ToolHost::cancel(Document& document) {
    const bool had_typed = !typed_.is_empty();
    typed_.clear();
    clear_message();
    if (state_ == MouseState::Dragging) state_ = MouseState::Up;
    if (document.is_attempting()) document.drop();
    return guarded(document, [&](ToolContext& given) { return tool_->cancel(given); }) || had_typed;
}

bool ToolHost::text(Document& document, std::string_view typed) {
    if (!typed_.add(typed)) return false;
    guarded(document, [&](ToolContext& given) { return tool_->hover(given, pointer_), true; });
    return true;
}

bool ToolHost::key(Document& document, Key key, const Modifiers& modifiers) {
    pointer_.modifiers = modifiers;
    return guarded(document, [&](ToolContext&) { return key_unguarded(document, key, modifiers); });
}

bool ToolHost::key_unguarded(Document& document, Key key, const Modifiers& modifiers) {
    if (key == Key::Escape) {
        if (cancel(document)) return true;
        if (!document.selection().is_empty()) return document.select({}), true;
        if (kind_ != ToolKind::Select) return choose(document, ToolKind::Select), true;
        return false;
    }
    if (!typed_.is_empty()) {
        if (key == Key::Backspace) return typed_.remove_last(), true;
        if (key == Key::Enter || key == Key::KeypadEnter) {
            const std::optional<std::vector<double>> numbers = typed_.numbers();
            ToolContext given = context(document);
            clear_message();
            if (!numbers) return message_ = "\"" + typed_.text() + "\" is no number", is_error_ = true, true;
            typed_.clear();
            if (!tool_->enter(given, *numbers)) message_ = "There is nothing here that takes a number";
            return true;
        }
        if (key == key_of('X')) return true;  // it comes as text: 30 x 40
    }
    ToolContext given = context(document);
    if (tool_->key(given, key, modifiers)) return true;
    if (key == Key::Delete || key == Key::Backspace) return remove_selected(document);
    if (key >= Key::Right && key <= Key::Up) return nudge(document, key, modifiers);
    if (modifiers.ctrl && !modifiers.alt && key == key_of('A')) return select_all(document);
    if (modifiers.ctrl || modifiers.alt || modifiers.shift) return false;
    const std::optional<ToolKind> wanted = tool_of_key(key);
    if (!wanted) return false;
    choose(document, *wanted);
    return true;
}

bool ToolHost::remove_selected(Document& document) {
    const Selection& selected = document.selection();
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
    clear_message();
    document.run(remove);
    return true;
}

bool ToolHost::nudge(Document& document, Key key, const Modifiers& modifiers) {
    const double step = modifiers.shift ? kLongNudge : kNudge;
    Vec2d by(0, 0);
    if (key == Key::Right) by.x() = step;
    if (key == Key::Left) by.x() = -step;
    if (key == Key::Up) by.y() = step;
    if (key == Key::Down) by.y() = -step;
    const std::optional<Command> command = move_selected(geometry_, document.selection(), by);
    if (!command) return false;
    clear_message();
    document.run(*command);
    return true;
}

bool ToolHost::select_all(Document& document) {
    Selection all;
    for (const PanelShape& shape : geometry_.panels()) all.panels.insert(shape.panel.name);
    document.select(all);
    return true;
}

ToolOverlay ToolHost::overlay(Document& document) {
    const ToolContext given = context(document);
    ToolOverlay overlay;
    tool_->draw(given, overlay);
    return overlay;
}

std::string ToolHost::hint(Document& document) {
    return tool_->hint(context(document));
}

}  // namespace selvedge
