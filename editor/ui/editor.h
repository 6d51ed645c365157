#pragma once
// The editor: takes the user's input of one frame and returns what to draw. Does not depend on a window, OpenGL or
// files: see editor/frame/frame.h and services.h.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/frame/frame.h"
#include "editor/frame/theme.h"
#include "editor/ui/app_state.h"
#include "editor/ui/services.h"

namespace selvedge::editor {

// Returns fonts that have as many of the letters as possible, the most suitable one first; none: there is none.
using FontFinder = std::function<std::vector<FallbackFont>(const Letters& letters)>;

struct EditorOptions {
    sim::SessionDrive drive = sim::SessionDrive::Thread;
    FontBytes fonts{};        // owned by the editor
    FontFinder find_fonts{};  // asked once for each letter that those lack; unset: such letters stay question marks
    bool is_steady = false;   // no blinking caret: the same input gives the same images
};

struct FrameSize {
    int width_px = 1280;
    int height_px = 800;
    float scale = 1;  // of the screen: 2 if text needs twice as many px

    bool operator==(const FrameSize&) const = default;
};

// Owns an ImGui context, which is current during frame() and until another one is made current.
class Editor {
 public:
    Editor(Services services, EditorOptions options);
    ~Editor();
    Editor(const Editor&) = delete;
    Editor& operator=(const Editor&) = delete;

    // Takes the events and returns what to draw; the draw lists are then ImGui's draw data. `seconds`: since the last
    // frame. Events that hide each other are taken one after the other before anything is drawn, so that keys do not
    // queue where drawing is slow.
    FrameOutput frame(const std::vector<InputEvent>& events, const FrameSize& size, double seconds);

    // Access to the system clipboard; without it the editor keeps copied text to itself.
    struct Clipboard {
        std::function<std::string()> get;
        std::function<void(const std::string&)> set;
    };
    void set_clipboard(Clipboard clipboard);

    AppState& state();
    const AppState& state() const;

    // Projects a point of the sheet (m) to px of the window.
    Vec2d sheet_to_px(const Vec2d& sheet) const;
    // Projects a 3D point (m) to px of the window, in the 3D view; none: behind the eye.
    std::optional<Vec2d> world_to_px(const Vec3d& point) const;

    // Whether events are queued for the next frames.
    bool has_more_input() const;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace selvedge::editor
