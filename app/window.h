#pragma once
// A window with a context of its own (GLFW, X11 or Wayland), and what a person does in it as events. One lives at a
// time, on the program's first thread; no other context may be current when it is made.
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
    int width = 1280;  // in the screen's units
    int height = 800;
    bool is_maximised = false;
    std::optional<float> scale{};  // of the interface; else the screen's
};

class Window {
 public:
    // Throws InputError when there is no display, or none with OpenGL 3.3.
    explicit Window(const WindowOptions& options = {});
    ~Window();

    render::GlContext& context();

    // Of the framebuffer, px; 0 while the window is hidden.
    int width_px() const;
    int height_px() const;
    float scale() const;  // of the interface: pixels per point, 1 on an ordinary screen

    // What was done since the last call, without waiting for more, or waiting until something is done or `seconds` are
    // over. Positions are px of the framebuffer.
    std::vector<editor::InputEvent> poll();
    std::vector<editor::InputEvent> wait(double seconds);

    // Ends a wait. From any thread.
    void wake();

    // Shows what was drawn to framebuffer 0 of the context; waits for the screen where it can. What is drawn there is
    // lost then, so draw all of it each time.
    void show();

    void set_title(const std::string& title);
    void set_cursor(editor::MouseCursor cursor);
    std::string clipboard() const;  // empty where it holds no text
    void set_clipboard(const std::string& text);

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// GLFW's keys and letters as the editor has them.

// code: as GLFW numbers keys, by their place on an American keyboard. printed: what the key writes in the layout that
// is in use, or empty; a letter goes before the place. None for keys that the editor does not know.
editor::Key key_of_code(int code, const std::string& printed);

std::string utf8_of(std::uint32_t code_point);

}  // namespace selvedge::app
