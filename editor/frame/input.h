#pragma once
// What a person does, as plain data: from a window, from a script, from a test. Positions in px of the framebuffer,
// from its upper left.
#include <string>
#include <vector>

namespace selvedge {

// Letters, digits and punctuation are their upper-case ASCII codes; the others follow.
enum class Key : int {
    None = 0,
    Space = 32,
    Escape = 256,
    Enter,
    Tab,
    Backspace,
    Insert,
    Delete,
    Right,
    Left,
    Down,
    Up,
    PageUp,
    PageDown,
    Home,
    End,
    F1 = 290,
    F2,
    F3,
    F4,
    F5,
    F6,
    F7,
    F8,
    F9,
    F10,
    F11,
    F12,
    Keypad0 = 320,
    Keypad9 = 329,
    KeypadDecimal,
    KeypadDivide,
    KeypadMultiply,
    KeypadSubtract,
    KeypadAdd,
    KeypadEnter,
};
inline constexpr Key key_of(char c) {
    return static_cast<Key>(c);
}

struct Modifiers {
    bool ctrl = false;
    bool shift = false;
    bool alt = false;

    bool operator==(const Modifiers&) const = default;
};

enum class MouseButton { Left, Right, Middle };

struct InputEvent {
    enum class Kind { MouseMove, MouseButton, Wheel, Key, Text, DropFiles, Focus, CloseRequest };

    Kind kind = Kind::MouseMove;
    float x = 0;  // px; of Wheel: notches
    float y = 0;
    MouseButton button = MouseButton::Left;
    Key key = Key::None;
    bool is_down = false;  // of MouseButton, Key, Focus
    Modifiers modifiers{};
    std::string text{};                // UTF-8, of Text
    std::vector<std::string> files{};  // of DropFiles
};

}  // namespace selvedge
