#include "editor/tools/tool_host.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/tools/select_tool.h"
#include "sim/pattern/fault.h"
#include "sim/pattern/outline.h"

namespace selvedge::editor {
namespace {

constexpr double kDragThreshold = 3;    // px
constexpr double kGridStepAtLeast = 5;  // px
constexpr double kNudge = 0.001;        // m
constexpr double kLongNudge = 0.01;     // m

// An outline that may cross itself, as a closed polyline in the panel's frame.
std::vector<Vec2d> refused_outline(const sim::Panel& panel) {
    constexpr int kPointsPerCurve = 48;
    std::vector<Vec2d> points;
    for (const sim::OutlineEdge& edge : panel.edges) {
        const int count = edge.kind == sim::CurveKind::Line ? 1 : kPointsPerCurve;
        for (int i = 0; i < count; ++i) points.push_back(curve_point(panel, edge, double(i) / count));
    }
    points.push_back(points.front());
    return points;
}

}  // namespace

ToolHost::ToolHost() : tool_(default_tool().make()) {}

ToolContext ToolHost::context(ToolHostContext host) {
    geometry_.update(host.document.pattern(), host.document.revision(), host.document.panel_states());
    const bool is_traced = !host.document.pattern().underlays.empty();  // then points follow the photo, not the grid
    return {.document = host.document,
            .geometry = geometry_,
            .hover = host.hover,
            .messages = host.messages,
            .drape = host.drape,
            .px = ui_scale_ / camera_.scale,
            .grid = is_traced ? 0 : grid_step(camera_, kGridStepAtLeast * ui_scale_),
            .is_snapping = is_snapping,
            .typed = typed_.numbers(),
            .pointer = pointer_};
}

// Runs an action; turns a GeometryError into a message that highlights the parts involved. Returns false in that case.
template <class Action>
bool ToolHost::guarded(ToolHostContext host, Action&& action) {
    ToolContext given = context(host);
    try {
        return action(given);
    } catch (const GeometryError& error) {
        const Message* shown = host.messages.shown();
        if (shown == nullptr || shown->text != error.what()) host.messages.error(error);  // once per drag
        return false;
    }
}

void ToolHost::choose(ToolHostContext host, const ToolInfo& tool) {
    cancel(host);
    state_ = MouseState::Up;
    host.messages.dismiss();
    info_ = &tool;
    tool_ = tool.make();
    if (pointer_.at.allFinite()) guarded(host, [&](ToolContext& given) { return tool_->hover(given, pointer_), true; });
}

void ToolHost::begin_frame(const Document& document, const SheetCamera& camera, double ui_scale) {
    camera_ = camera;
    ui_scale_ = ui_scale;
    geometry_.update(document.pattern(), document.revision(), document.panel_states());
}

void ToolHost::move(ToolHostContext host, const Vec2d& px, const Modifiers& modifiers) {
    if (is_asking_) return;
    pointer_ = {to_sheet(camera_, px), modifiers};
    is_over_ = true;
    if (state_ == MouseState::Pressed && (px - pressed_px_).norm() > kDragThreshold * ui_scale_) {
        state_ = MouseState::Dragging;
    }
    guarded(host, [&](ToolContext& given) {
        if (state_ == MouseState::Up) tool_->hover(given, pointer_);
        if (state_ == MouseState::Dragging) drag(given);
        return true;
    });
}

void ToolHost::drag(ToolContext& given) {
    const std::size_t said = given.messages.count();
    refused_.reset();
    try {
        tool_->drag(given, pointer_);
    } catch (const GeometryError& error) {
        refused_ = error;
        given.document.rollback();
        throw;
    }
    if (given.messages.count() == said) given.messages.dismiss();  // no error now: hide the old message
}

// Says why nothing has changed if the drag ends where it is not possible.
void ToolHost::drop(ToolHostContext host) {
    const std::optional<GeometryError> refused = std::exchange(refused_, std::nullopt);
    guarded(host, [&](ToolContext& given) { return tool_->drop(given, pointer_), true; });
    if (!refused || refused->refused_panels().empty()) return;
    host.messages.error(GeometryError(std::string(refused->what()) + " It is as before the drag.", refused->places()));
}

void ToolHost::press(ToolHostContext host, const Vec2d& px, const Modifiers& modifiers) {
    if (is_asking_) end_asking(host);
    host.messages.dismiss();
    pointer_ = {to_sheet(camera_, px), modifiers};
    is_over_ = true;
    pressed_px_ = px;
    state_ = MouseState::Pressed;
    guarded(host, [&](ToolContext& given) {
        tool_->hover(given, pointer_);
        tool_->press(given, pointer_);
        return true;
    });
}

void ToolHost::release(ToolHostContext host, const Vec2d& px, const Modifiers& modifiers) {
    if (state_ == MouseState::Up || is_asking_) return;
    move(host, px, modifiers);
    const bool was_dragged = state_ == MouseState::Dragging;
    state_ = MouseState::Up;
    if (was_dragged) {
        drop(host);
    } else {
        guarded(host, [&](ToolContext& given) { return tool_->click(given, pointer_), true; });
    }
    guarded(host, [&](ToolContext& given) { return tool_->hover(given, pointer_), true; });
}

void ToolHost::double_click(ToolHostContext host, const Vec2d& px, const Modifiers& modifiers) {
    pointer_ = {to_sheet(camera_, px), modifiers};
    guarded(host, [&](ToolContext& given) { return tool_->double_click(given, pointer_), true; });
}

void ToolHost::leave(ToolHostContext host) {
    if (state_ == MouseState::Up && std::exchange(is_over_, false)) host.hover = {};
}

bool ToolHost::run(ToolHostContext host, const Command& command) {
    host.messages.dismiss();
    return guarded(host, [&](ToolContext& given) { return given.document.run(command), true; });
}

bool ToolHost::cancel(ToolHostContext host) {
    const bool had_typed = !typed_.is_empty() || is_asking_;
    typed_.clear();
    is_asking_ = false;
    host.messages.dismiss();
    if (state_ == MouseState::Dragging) state_ = MouseState::Up;
    refused_.reset();
    if (host.document.is_previewing()) host.document.rollback();
    return guarded(host, [&](ToolContext& given) { return tool_->cancel(given); }) || had_typed;
}

bool ToolHost::text(ToolHostContext host, std::string_view typed) {
    if (!typed_.add(typed)) return false;
    guarded(host, [&](ToolContext& given) { return tool_->hover(given, pointer_), true; });
    return true;
}

bool ToolHost::key(ToolHostContext host, Key key, const Modifiers& modifiers) {
    pointer_.modifiers = modifiers;
    return guarded(host, [&](ToolContext&) { return key_unguarded(host, key, modifiers); });
}

bool ToolHost::key_unguarded(ToolHostContext host, Key key, const Modifiers& modifiers) {
    if (key == Key::Escape) {
        if (is_asking_ && state_ != MouseState::Dragging) return is_asking_ = false, typed_.clear(), true;
        if (cancel(host)) return true;
        if (!host.document.selection().is_empty()) return host.document.select({}), true;
        if (info_ != &default_tool()) return choose(host, default_tool()), true;
        return false;
    }
    if (!typed_.is_empty() || is_asking_) {
        if (key == Key::Backspace) return typed_.remove_last(), true;
        if (key == Key::Enter || key == Key::KeypadEnter) return enter_number(host);
        if (key == key_of('X')) return true;  // arrives as text: 30 x 40
    }
    ToolContext given = context(host);
    if (tool_->key(given, key, modifiers)) return true;
    if (key == Key::Delete || key == Key::Backspace) return remove_selected(host);
    if (key >= Key::Right && key <= Key::Up) return nudge(host, key, modifiers);
    if (modifiers.ctrl && !modifiers.alt && key == key_of('A')) return select_all(host);
    if (key == Key::Tab && !modifiers.ctrl && !modifiers.alt) return select_next(host, modifiers.shift);
    if (modifiers.ctrl || modifiers.alt || modifiers.shift) return false;
    const ToolInfo* wanted = tool_of_key(key, key_map);
    if (wanted == nullptr) return false;
    choose(host, *wanted);
    return true;
}

bool ToolHost::ask_number(ToolHostContext host) {
    if (is_asking_ || !info_->takes_numbers) return is_asking_;
    const bool is_drawing = info_->is_drawing && !overlay(host).readout.empty();
    return is_asking_ = state_ == MouseState::Dragging || is_drawing;
}

// Without a number: what is dragged ends where it is.
void ToolHost::end_asking(ToolHostContext host) {
    is_asking_ = false;
    typed_.clear();
    if (std::exchange(state_, MouseState::Up) == MouseState::Dragging) drop(host);
}

bool ToolHost::enter_number(ToolHostContext host) {
    if (typed_.is_empty()) return end_asking(host), true;
    const std::optional<std::vector<double>> numbers = typed_.numbers();
    host.messages.dismiss();
    if (!numbers) return host.messages.warn("\"" + typed_.text() + "\" is no number"), true;
    typed_.clear();
    is_asking_ = false;
    state_ = MouseState::Up;  // a drag ends: the number replaces what the mouse has done
    refused_.reset();
    if (host.document.is_previewing()) host.document.rollback();
    ToolContext given = context(host);
    if (!tool_->enter(given, *numbers)) host.messages.warn("This tool does not use a number here");
    return true;
}

bool ToolHost::remove_selected(ToolHostContext host) {
    const Selection selected = host.document.changeable();
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
    host.messages.dismiss();
    host.document.run(remove);
    return true;
}

bool ToolHost::nudge(ToolHostContext host, Key key, const Modifiers& modifiers) {
    const double step = modifiers.shift ? kLongNudge : kNudge;
    Vec2d by(0, 0);
    if (key == Key::Right) by.x() = step;
    if (key == Key::Left) by.x() = -step;
    if (key == Key::Up) by.y() = step;
    if (key == Key::Down) by.y() = -step;
    const std::optional<Command> command = move_selected(geometry_, host.document.changeable(), by);
    if (!command) return false;
    host.messages.dismiss();
    host.document.run(*command);
    return true;
}

// The next panel; with a tool that picks parts, the next point of the panels that have a selected part. `is_back`: the
// one before.
bool ToolHost::select_next(ToolHostContext host, bool is_back) {
    const Selection& selected = host.document.selection();
    std::vector<Selection> choices;
    std::optional<std::size_t> chosen;
    const std::set<std::string> touched = touched_panels(selected);
    const bool picks_points = info_->picks_parts && !touched.empty();
    const auto offer = [&](const Selection& choice) {
        if (choice == selected) chosen = choices.size();
        choices.push_back(choice);
    };
    for (const PanelShape& shape : geometry_.panels()) {
        if (!shape.may_be_picked) continue;
        if (!picks_points) {
            Selection choice;
            choice.panels.insert(shape.panel.name);
            offer(choice);
            continue;
        }
        if (!touched.contains(shape.panel.name)) continue;
        for (std::size_t v = 0; v < shape.panel.vertices.size(); ++v) {
            Selection choice;
            choice.vertices.insert({shape.panel.name, static_cast<int>(v)});
            offer(choice);
        }
    }
    if (choices.empty()) return false;
    const std::size_t count = choices.size();
    const std::size_t first = is_back ? count - 1 : 0, step = is_back ? count - 1 : 1;
    host.document.select(choices[chosen ? (*chosen + step) % count : first]);
    return true;
}

bool ToolHost::select_all(ToolHostContext host) {
    Selection all;
    for (const PanelShape& shape : geometry_.panels()) all.panels.insert(shape.panel.name);
    host.document.select(pickable(all, host.document.panel_states(), host.document.pattern()));
    return true;
}

ToolOverlay ToolHost::overlay(ToolHostContext host) {
    const ToolContext given = context(host);
    ToolOverlay overlay;
    tool_->draw(given, overlay);
    if (refused_) add_refused(overlay);
    return overlay;
}

// Adds the outlines that the drag would make, unless they reach too far to be drawn.
void ToolHost::add_refused(ToolOverlay& overlay) const {
    overlay.problem = refused_->what();
    for (const sim::Panel& panel : refused_->refused_panels()) {
        const PanelShape* shape = geometry_.find(panel.name);
        if (shape == nullptr) continue;
        OverlayLine line{.points = refused_outline(panel), .tone = OverlayTone::Warning};
        const auto is_near = [](const Vec2d& p) {
            return p.allFinite() && p.cwiseAbs().maxCoeff() <= sim::kMaxCoordinate;
        };
        if (!std::all_of(line.points.begin(), line.points.end(), is_near)) continue;
        for (Vec2d& point : line.points) point = shape->on_sheet(point);
        overlay.lines.push_back(std::move(line));
    }
}

std::string ToolHost::hint(ToolHostContext host) {
    return tool_->hint(context(host));
}

}  // namespace selvedge::editor
