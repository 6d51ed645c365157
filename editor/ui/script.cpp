#include "editor/ui/script.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>

#include "editor/document/command.h"
#include "editor/geometry/draft.h"
#include "editor/geometry/panel_edit.h"
#include "editor/ui/actions.h"
#include "editor/ui/export_thickness.h"
#include "editor/ui/files.h"
#include "editor/ui/paper_options.h"
#include "editor/viewport3d/viewport_overlay.h"
#include "sim/core/error.h"

namespace selvedge::editor {
namespace {

constexpr double kCm = 0.01;
constexpr int kMaxFrames = 100000;

// The words after a PLACE: mouse button and modifiers.
struct PointerState {
    MouseButton button = MouseButton::Left;
    Modifiers modifiers{};
};

PointerState pointer_state_of(const ScriptStep& step, std::size_t at) {
    PointerState pointer;
    for (; at < step.arguments.size(); ++at) {
        const std::string& word = step.arguments[at];
        if (word == "shift") pointer.modifiers.shift = true;
        if (word == "ctrl") pointer.modifiers.ctrl = true;
        if (word == "alt") pointer.modifiers.alt = true;
        if (word == "right") pointer.button = MouseButton::Right;
        if (word == "middle") pointer.button = MouseButton::Middle;
    }
    return pointer;
}

}  // namespace

void ScriptPlayer::play(const std::vector<ScriptStep>& steps) {
    for (const ScriptStep& step : steps) {
        try {
            play(step);
        } catch (const sim::InputError& error) {
            if (error.file() == file_) throw;
            fail(step, error.what());
        } catch (const GeometryError& error) {
            fail(step, error.what());
        }
    }
}

void ScriptPlayer::play(const ScriptStep& step) {
    const std::string& verb = step.verb;
    if (verb == "frames") return wait_frames(whole_number(step, 0));
    if (verb == "settle") return settle(number(step, 0));
    if (verb == "expect") return expect(step);
    if (verb == "screenshot") return stage_.screenshot(word(step, 0));
    if (verb == "where") {
        std::size_t at = 0;
        const Vec2d px = place(step, at);
        return stage_.say(std::to_string(px.x()) + " " + std::to_string(px.y()));
    }
    if (verb == "key") {
        const auto chord = parse_chord(word(step, 0));
        if (!chord) fail(step, "'" + word(step, 0) + "' is no key");
        return press_key(*chord);
    }
    if (verb == "type") return send({.kind = InputEvent::Kind::Text, .text = step.rest});
    if (verb == "action") {
        const Action* action = find_action(editor_.state().actions, word(step, 0));
        if (action == nullptr) fail(step, "there is no action '" + word(step, 0) + "'");
        if (!run_action(editor_.state(), *action)) fail(step, "'" + action->title + "' cannot be done now");
        return wait_frames(1);
    }
    const bool is_of_document = verb == "open" || verb == "new" || verb == "save" || verb == "do" || verb == "export" ||
                                verb == "wear" || verb == "import" || verb == "print";
    is_of_document ? play_document(step) : play_mouse(step);
}

void ScriptPlayer::expect(const ScriptStep& step) const {
    const std::string text = stage_badge(*editor_.state().workspace.drape.frame());
    if (text != step.rest && !text.starts_with(step.rest + ","))
        fail(step, "the drape is not '" + step.rest + "' but '" + text + "'");
}

void ScriptPlayer::play_document(const ScriptStep& step) {
    AppState& state = editor_.state();
    if (step.verb == "new") new_document(state);
    if (step.verb == "open") open_file(state, word(step, 0));
    const auto options = [&] { return std::span(step.arguments).subspan(1); };
    if (step.verb == "import") import_file(state, word(step, 0), parse_import_options(options()));
    if (step.verb == "print")  // nobody is there to ask
        print_to(state, word(step, 0), parse_print_options(options()), IfExists::Replace);
    if (step.verb == "save") save_as(state, word(step, 0), IfExists::Replace);
    if (step.verb == "export") {
        const bool is_thick = step.arguments.size() > 1 && word(step, 1) == "thickness";
        export_to(state, word(step, 0), is_thick ? parse_export_thickness(word(step, 2)) : ExportThickness{},
                  IfExists::Replace);
    }
    if (step.verb == "wear") state.workspace.drape.show_body(step.rest);
    if (step.verb == "do") {
        const sim::Json json = sim::parse_json(step.rest, file_);
        state.workspace.document->run(parse_command(sim::JsonView(json, file_)));
    }
    wait_frames(2);
    const Message* message = state.workspace.messages.shown();
    if (message != nullptr && message->kind == MessageKind::Error) fail(step, message->text);
}

void ScriptPlayer::play_mouse(const ScriptStep& step) {
    std::size_t at = 0;
    const Vec2d px = place(step, at);
    const bool is_drag = step.verb == "drag";
    Vec2d to = px;
    if (is_drag) {
        if (word(step, at) != "to") fail(step, "'to' and a second place should follow the first");
        to = place(step, ++at);
    }
    const double notches = step.verb == "wheel" ? number(step, at) : 0;
    const PointerState pointer = pointer_state_of(step, at);
    move_to(px, pointer.modifiers);
    if (step.verb == "wheel") {
        send({.kind = InputEvent::Kind::Wheel, .y = static_cast<float>(notches), .modifiers = pointer.modifiers});
    }
    const bool presses = step.verb == "press" || step.verb == "click" || step.verb == "double" || is_drag;
    if (presses) set_button(pointer.button, true, pointer.modifiers);
    if (is_drag) {
        constexpr int kMoves = 8;
        for (int i = 1; i <= kMoves; ++i) move_to(px + (to - px) * (i / double(kMoves)), pointer.modifiers);
    }
    if (step.verb != "press" && (presses || step.verb == "release"))
        set_button(pointer.button, false, pointer.modifiers);
    if (step.verb == "double") {
        set_button(pointer.button, true, pointer.modifiers);
        set_button(pointer.button, false, pointer.modifiers);
    }
}

Vec2d ScriptPlayer::place(const ScriptStep& step, std::size_t& at) const {
    const std::string& kind = word(step, at++);
    const AppState& state = editor_.state();
    const auto take = [&] { return number(step, at++); };
    if (kind == "px") {
        const double x = take();
        return {x, take()};
    }
    if (kind == "sheet") {
        const double x = take();
        return editor_.sheet_to_px(kCm * Vec2d(x, take()));
    }
    if (kind == "panel") {
        const std::string& name = word(step, at++);
        const PanelShape* shape = state.tools.geometry().find(name);
        if (shape == nullptr) fail(step, "there is no panel '" + name + "'");
        const double x = take();
        return editor_.sheet_to_px(shape->on_sheet(kCm * Vec2d(x, take())));
    }
    if (kind == "vertex") {
        const std::string& name = word(step, at++);
        const auto vertex = state.tools.geometry().vertex({name, whole_number(step, at++)});
        if (!vertex) fail(step, "'" + name + "' has no such point");
        return editor_.sheet_to_px(*vertex);
    }
    if (kind == "widget") {
        constexpr int kFramesToShow = 30;  // what was asked for just before may be drawn a few frames later
        const auto is_shown = [&] { return state.widgets.contains(word(step, at)); };
        for (int i = 0; i < kFramesToShow && !is_shown(); ++i) stage_.step({});
        const auto found = state.widgets.find(word(step, at));
        if (found == state.widgets.end()) fail(step, "nothing on the screen is called '" + word(step, at) + "'");
        ++at;
        return found->second.centre().cast<double>();
    }
    Vec3d point = Vec3d::Zero();
    if (kind == "point") {
        const std::string& name = word(step, at++);
        const std::vector<sim::ArrangementPoint>& points = state.workspace.drape.current_body().points;
        const auto found = std::find_if(points.begin(), points.end(),
                                        [&](const sim::ArrangementPoint& known) { return known.name == name; });
        if (found == points.end()) fail(step, "the body has no arrangement point '" + name + "'");
        point = found->position;
    } else if (kind == "room") {
        point.x() = take();
        point.y() = take();
        point.z() = take();
    } else {
        fail(step, "'" + kind + "' is no place: sheet, panel, widget, point, room and px are");
    }
    const auto seen = editor_.world_to_px(point);
    if (!seen) fail(step, "the place is not seen from here");
    return *seen;
}

const std::string& ScriptPlayer::word(const ScriptStep& step, std::size_t at) const {
    if (at >= step.arguments.size()) fail(step, "something is missing after '" + step.verb + "'");
    return step.arguments[at];
}

double ScriptPlayer::number(const ScriptStep& step, std::size_t at) const {
    const std::string& text = word(step, at);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
        fail(step, "'" + text + "' is no number");
    }
    return value;
}

int ScriptPlayer::whole_number(const ScriptStep& step, std::size_t at) const {
    constexpr double kMost = 1e9;
    const double value = number(step, at);
    if (!(value >= 0 && value <= kMost && value == std::floor(value)))
        fail(step, "'" + word(step, at) + "' is no whole number from 0 on");
    return static_cast<int>(value);
}

void ScriptPlayer::fail(const ScriptStep& step, const std::string& problem) const {
    throw sim::InputError(file_, "line " + std::to_string(step.line), problem);
}

// Steps until the editor has processed the event, and one frame more to show the result.
void ScriptPlayer::send(const InputEvent& event) {
    stage_.step({event});
    while (editor_.has_more_input()) stage_.step({});
    stage_.step({});
}

void ScriptPlayer::move_to(const Vec2d& px, const Modifiers& modifiers) {
    mouse_ = px;
    send({.kind = InputEvent::Kind::MouseMove,
          .x = static_cast<float>(px.x()),
          .y = static_cast<float>(px.y()),
          .modifiers = modifiers});
}

void ScriptPlayer::set_button(MouseButton button, bool is_down, const Modifiers& modifiers) {
    send({.kind = InputEvent::Kind::MouseButton,
          .x = static_cast<float>(mouse_.x()),
          .y = static_cast<float>(mouse_.y()),
          .button = button,
          .is_down = is_down,
          .modifiers = modifiers});
}

void ScriptPlayer::press_key(const Chord& chord) {
    send({.kind = InputEvent::Kind::Key, .key = chord.key, .is_down = true, .modifiers = chord.modifiers});
    send({.kind = InputEvent::Kind::Key, .key = chord.key, .is_down = false, .modifiers = {}});
}

void ScriptPlayer::wait_frames(int frames) {
    for (int i = 0; i < std::clamp(frames, 0, kMaxFrames); ++i) stage_.step({});
}

// Advances the drape without drawing, then shows two frames.
void ScriptPlayer::settle(double seconds) {
    sim::Session& session = editor_.state().workspace.drape.session();
    const double end = session.frame()->statistics.simulated_seconds + seconds;
    stage_.step({});
    for (int i = 0; i < kMaxFrames && session.frame()->is_running; ++i) {
        const sim::SessionFrame& frame = *session.frame();
        if (frame.stage == sim::SessionStage::Settled || frame.statistics.simulated_seconds >= end) break;
        session.advance(1);
    }
    wait_frames(2);
}

}  // namespace selvedge::editor
