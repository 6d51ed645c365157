#pragma once
// A window with its own GL context (GLFW, X11 or Wayland), and the user's input as events. Only one may exist at a
// time, on the main thread; no other GL context may be current when it is created.
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/frame/frame.h"
#include "render/gl/context.h"

namespace selvedge::app {

struct WindowOptions {
    std::string title = "Selvedge";
    int width = 1280;  // screen units
    int height = 800;
    bool is_maximised = false;
    std::optional<float> scale{};  // of the interface; none: the screen's
};

class Window {
 public:
    // Throws InputError if there is no display, or none that supports OpenGL 3.3.
    explicit Window(const WindowOptions& options = {});
    ~Window();

    render::GlContext& context();

    // Framebuffer size, px; 0 while the window is hidden.
    int width_px() const;
    int height_px() const;
    float scale() const;  // of the interface: pixels per point, 1 on an ordinary screen

    // Returns the events since the last call. poll() does not wait; wait() waits for an event, at most `seconds`.
    // Positions are px of the framebuffer.
    std::vector<editor::InputEvent> poll();
    std::vector<editor::InputEvent> wait(double seconds);

    // Shows the content of framebuffer 0; waits for vertical sync where supported. The content is undefined afterwards,
    // so draw all of it in each frame.
    void show();

    void set_title(const std::string& title);
    void set_cursor(editor::MouseCursor cursor);
    std::string clipboard() const;  // empty if it holds no text
    void set_clipboard(const std::string& text);

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// Conversion of GLFW's keys and characters to the editor's.

// code: GLFW's key code, which is the position on a US keyboard. printed: what the key types in the current layout, or
// empty; if it is a letter, it has priority over the position. None for unknown keys.
editor::Key key_of_code(int code, const std::string& printed);

std::string utf8_of(std::uint32_t code_point);

}  // namespace selvedge::app
