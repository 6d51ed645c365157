#pragma once
// The editor, from one frame to the next: takes what a person did, and says what is to be seen. Knows no window, no GL
// and no files: see frame_output.h and services.h.
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

struct EditorOptions {
    sim::SessionDrive drive = sim::SessionDrive::Thread;
    FontBytes fonts{};       // bytes that the editor keeps
    bool is_steady = false;  // no blinking caret: the same input gives the same pictures
};

struct FrameSize {
    int width_px = 1280;
    int height_px = 800;
    float scale = 1;  // of the screen: 2 where letters take twice as many px

    bool operator==(const FrameSize&) const = default;
};

// Owns an ImGui context; it is the present one during frame() and until another is made.
class Editor {
 public:
    Editor(Services services, EditorOptions options);
    ~Editor();
    Editor(const Editor&) = delete;
    Editor& operator=(const Editor&) = delete;

    // Builds one frame, whose lists are then ImGui's draw data. `seconds` since the last one.
    FrameOutput frame(const std::vector<InputEvent>& events, const FrameSize& size, double seconds);

    // Where texts are copied to and from; without one they stay with the editor.
    struct Clipboard {
        std::function<std::string()> get;
        std::function<void(const std::string&)> set;
    };
    void set_clipboard(Clipboard clipboard);

    AppState& desk();
    const AppState& desk() const;

    // Where a place of the sheet (m) is seen, px.
    Vec2d sheet_to_px(const Vec2d& sheet) const;
    // Where a point of the room (m) is seen in the 3D view, px; none: behind the eye.
    std::optional<Vec2d> room_to_px(const Vec3d& point) const;

    // Events are left for further frames.
    bool has_more_input() const;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace selvedge::editor
