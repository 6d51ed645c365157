#pragma once
// What one frame of the editor asks of whoever shows it: scenes to draw into textures, pictures to hold as textures,
// and then ImGui's draw lists. The editor names textures by numbers of its own and knows no GL.
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "render/image/image.h"
#include "render/scene/scene.h"
#include "sim/core/math.h"

namespace selvedge::editor {

// In ImGui's draw lists, as ImTextureID. 0 is the font's.
using UiTexture = std::uint32_t;

// A scene to be drawn into a texture before the draw lists are.
struct SceneToDraw {
    UiTexture texture = 0;
    std::shared_ptr<const render::Scene> scene;  // the same pointer: the same scene but for its camera and lights
    render::Camera camera;
    render::Light light;
    int width_px = 0;
    int height_px = 0;
    bool is_draft = true;      // fast: no shadows, no room light, one sample
    UiTexture legend = 0;      // gets a clear picture of the same size with the legend, where the mode is painted
    bool wants_paint = false;  // the mode of its first cloth is to be filled in first (render/marks/show.h)
};

// A picture to be held as a texture that repeats, until another of that number comes.
struct PictureToHold {
    UiTexture texture = 0;
    render::Image picture;
};

enum class MouseCursor { Arrow, Text, Hand, Cross, ResizeHorizontal, ResizeVertical, Hidden };

struct FrameOutput {
    std::vector<PictureToHold> pictures;
    std::vector<SceneToDraw> scenes;  // only those that changed: a texture keeps what was drawn
    std::string window_title;
    MouseCursor cursor = MouseCursor::Arrow;
    bool wants_to_close = false;
    bool is_animating = false;  // wants a frame as soon as may be, else an event may be waited for
};

// What a person does, as plain data: from a window, from a script, from a test. Positions in px of the framebuffer,
// from its upper left.

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

// Where named controls stand on the screen, so that scripts and tests can click them by name.

struct WidgetBox {
    Vec2f low{0, 0};  // px of the framebuffer, upper left
    Vec2f high{0, 0};

    Vec2f centre() const { return (low + high) / 2; }
};

// As of the last frame.
using WidgetMap = std::map<std::string, WidgetBox>;

}  // namespace selvedge::editor
