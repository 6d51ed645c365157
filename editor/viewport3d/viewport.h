#pragma once
// The 3D view, in ImGui: an image of the scene, and over it the gizmo, names and badges.
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "editor/frame/frame.h"
#include "editor/viewport3d/viewport_controller.h"
#include "editor/viewport3d/viewport_marks.h"
#include "editor/viewport3d/viewport_scene.h"

namespace selvedge::editor {

// What the view is given each frame.
struct ViewportContext {
    Workspace& workspace;
    FrameOutput& output;
    UiTexture texture = 1;  // that the scene is drawn into
    UiTexture legend = 2;   // that a painted mode's legend is drawn into
    float seconds = 0;      // since the last frame
    float scale = 1;        // of the interface
    ClothChoice choice = ClothChoice::Panels;
};

class Viewport {
 public:
    explicit Viewport(ViewportColours colours = {}) : colours_(colours), scene_(colours) {}

    // Fills the region that is left of the current window. Asks for the scene to be drawn where something of it has
    // changed.
    void show(const ViewportContext& context);

    // As of the last frame; null: there is nothing to be seen.
    const std::shared_ptr<const render::Scene>& scene() const { return shown_; }
    render::Camera camera() const { return hand_.orbit().camera(); }
    render::Light light() const { return light_; }
    bool is_focused() const { return is_focused_; }

    // Where a point of the room was seen, px of the window; none: behind the eye.
    std::optional<Vec2f> room_to_px(const Vec3f& x) const;

    ViewportController& hand() { return hand_; }
    const ViewportController& hand() const { return hand_; }

 private:
    // What the texture was last asked to show.
    struct Drawn {
        std::shared_ptr<const render::Scene> scene;
        Standpoint standpoint;
        int width_px = 0;
        int height_px = 0;
        UiTexture texture = 0;

        bool operator==(const Drawn&) const = default;
    };

    ViewportInput take_input(const ViewportContext& context);
    void make_scene(const ViewportContext& context);
    void ask_for_picture(const ViewportContext& context);
    void choose_cursor(const ViewportContext& context) const;

    ViewportColours colours_;
    ViewportController hand_;
    ViewportScene scene_;
    std::shared_ptr<const render::Scene> shown_;
    render::Light light_;
    Drawn drawn_;
    Vec2f low_px_{0, 0};  // the view's upper left in the window
    Vec2f size_px_{1, 1};
    bool is_focused_ = false;
};

}  // namespace selvedge::editor
