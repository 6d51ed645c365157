#pragma once
// The interface between the editor and the program that hosts it. Output of a frame: scenes to draw into textures,
// images to upload as textures, and ImGui's draw lists. Input: events and named widgets as plain data. The editor
// identifies textures by its own numbers and makes no GL calls.
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/image/image.h"
#include "render/scene/scene.h"
#include "sim/core/math.h"
#include "sim/tartan/sett.h"

namespace selvedge::editor {

// Used as ImTextureID in ImGui's draw lists. 0 is the font atlas.
using UiTexture = std::uint32_t;

// A scene to draw into a texture before the draw lists are drawn.
struct SceneRequest {
    UiTexture texture = 0;
    std::shared_ptr<const render::Scene> scene;  // same pointer: only camera and light changed
    render::Camera camera;
    render::Light light;
    int width_px = 0;
    int height_px = 0;
    bool is_preview = true;        // fast preview: no shadows, no ambient occlusion, one sample per pixel
    std::optional<int> sample{};   // of a preview that rests: this sample is added to those before, from 0 on
    UiTexture legend = 0;          // receives the legend on a transparent image of the same size, if fills_show_mode
    bool fills_show_mode = false;  // before drawing, fill in the show mode of the first cloth (render/marks/show.h)
};

// An image to upload as a repeating texture. It stays until another image with the same number replaces it.
struct TextureUpload {
    UiTexture texture = 0;
    render::Image picture{};
    std::optional<sim::Rgb8> around{};  // the colour around a picture that is placed once; none: it repeats
    bool has_levels = false;            // smaller levels are made of it, for a picture that is shown at any size
};

enum class MouseCursor { Arrow, Text, Hand, Cross, ResizeHorizontal, ResizeVertical, Hidden };

struct FrameOutput {
    std::vector<TextureUpload> pictures;
    std::vector<SceneRequest> scenes;  // only changed scenes: a texture keeps its content
    std::string window_title;
    MouseCursor cursor = MouseCursor::Arrow;
    bool wants_to_close = false;
    bool is_animating = false;  // true: draw the next frame at once; false: the host may wait for an event
};

// User input as plain data: from a window, a script or a test. Positions are in px of the framebuffer, with the origin
// at its upper left.

// Letters, digits and punctuation have their upper-case ASCII codes; the other keys have the values below.
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

// Which keys choose tools, views and commands: the editor's own, or those of Marvelous Designer as far as it has the
// same commands.
enum class KeyMap { Selvedge, MarvelousDesigner };

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
    float x = 0;  // px; for Wheel: wheel notches
    float y = 0;
    MouseButton button = MouseButton::Left;
    Key key = Key::None;
    bool is_down = false;  // for MouseButton, Key, Focus
    Modifiers modifiers{};
    std::string text{};                // UTF-8, for Text
    std::vector<std::string> files{};  // for DropFiles
};

// Screen rectangles of named widgets, so that scripts and tests can click a widget by name.

struct WidgetBox {
    Vec2f low{0, 0};  // px of the framebuffer, upper left corner
    Vec2f high{0, 0};

    Vec2f centre() const { return (low + high) / 2; }
};

// Widgets of the last frame, by name.
using WidgetMap = std::map<std::string, WidgetBox>;

}  // namespace selvedge::editor
