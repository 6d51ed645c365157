#include "editor/ui/ui_input.h"
#include "editor/frame/keyboard.h"

#include <imgui.h>

#include <array>
#include <utility>

namespace selvedge::editor {
namespace {

using Kind = InputEvent::Kind;

// The kinds of events that the current frame has already received.
struct Taken {
    bool button = false;
    bool key = false;
    bool text = false;
    bool wheel = false;
};

// A button event must be seen at its own cursor position, and text must arrive with its key.
bool fits(const InputEvent& event, const Taken& taken) {
    switch (event.kind) {
        case Kind::MouseMove:
            return !taken.button && !taken.wheel;
        case Kind::MouseButton:
            return !taken.button && !taken.key;
        case Kind::Wheel:
            return !taken.button;
        case Kind::Key:
            return !taken.key && !taken.text && !taken.button;
        case Kind::Text:
            return !taken.button && !taken.text;
        case Kind::DropFiles:
        case Kind::Focus:
        case Kind::CloseRequest:
            return true;
    }
    return true;
}

void set_modifiers(ImGuiIO& io, const Modifiers& modifiers) {
    io.KeyCtrl = modifiers.ctrl;
    io.KeyShift = modifiers.shift;
    io.KeyAlt = modifiers.alt;
}

void release_all(ImGuiIO& io) {
    for (bool& is_down : io.KeysDown) is_down = false;
    for (bool& is_down : io.MouseDown) is_down = false;
    set_modifiers(io, {});
}

void hand_over(ImGuiIO& io, const InputEvent& event, Taken& taken) {
    switch (event.kind) {
        case Kind::MouseMove:
            io.MousePos = ImVec2(event.x, event.y);
            break;
        case Kind::MouseButton:
            io.MousePos = ImVec2(event.x, event.y);
            io.MouseDown[static_cast<int>(event.button)] = event.is_down;
            set_modifiers(io, event.modifiers);
            taken.button = true;
            break;
        case Kind::Wheel:
            io.MouseWheel += event.y;
            io.MouseWheelH += event.x;
            set_modifiers(io, event.modifiers);
            taken.wheel = true;
            break;
        case Kind::Key:
            set_key(io, event.key, event.is_down);
            set_modifiers(io, event.modifiers);
            taken.key = true;
            break;
        case Kind::Text:
            io.AddInputCharactersUTF8(event.text.c_str());
            taken.text = true;
            break;
        case Kind::Focus:
            if (!event.is_down) release_all(io);
            break;
        case Kind::DropFiles:
        case Kind::CloseRequest:
            break;
    }
}

}  // namespace

void UiInput::add(const std::vector<InputEvent>& events) {
    for (const InputEvent& event : events) {
        const bool is_move = event.kind == Kind::MouseMove;
        if (is_move && !waiting_.empty() && waiting_.back().kind == Kind::MouseMove) waiting_.pop_back();
        waiting_.push_back(event);
    }
}

std::vector<InputEvent> UiInput::begin_frame(ImGuiIO& io) {
    std::vector<InputEvent> others;
    Taken taken;
    while (!waiting_.empty() && fits(waiting_.front(), taken)) {
        const InputEvent event = std::move(waiting_.front());
        waiting_.pop_front();
        hand_over(io, event, taken);
        if (event.kind == Kind::DropFiles || event.kind == Kind::CloseRequest) others.push_back(event);
    }
    return others;
}

}  // namespace selvedge::editor
