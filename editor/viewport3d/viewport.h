#pragma once
// The 3D view in ImGui: shows the rendered scene, and draws the gizmo, labels and badges over it.
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "editor/frame/frame.h"
#include "editor/viewport3d/curved_drape.h"
#include "editor/viewport3d/viewport_controller.h"
#include "editor/viewport3d/viewport_marks.h"
#include "editor/viewport3d/viewport_scene.h"

namespace selvedge::editor {

// Input of the view for one frame.
struct ViewportContext {
    Workspace& workspace;
    FrameOutput& output;
    UiTexture texture = 1;  // the scene is rendered into it
    UiTexture legend = 2;   // receives the legend if the show mode maps values to colours
    float seconds = 0;      // s, since the last frame
    float scale = 1;        // interface scale factor
    ClothChoice choice = ClothChoice::Panels;
    KeyMap key_map = KeyMap::Selvedge;
    bool may_refine = true;  // false: a request of this frame may be replaced before it is drawn, so it is no sample
    WidgetMap* widgets = nullptr;           // receives the position of the badge; may be null
    std::function<void()> show_findings{};  // the badge was clicked; unset: it is no button
};

class Viewport {
 public:
    explicit Viewport(ViewportColours colours = {}) : colours_(colours), scene_(colours) {}

    void set_colours(const ViewportColours& colours);

    // Fills the remaining region of the current ImGui window. Requests a new rendering of the scene only if something
    // in it has changed, and then, once it rests, one sample after the other of a smooth picture.
    void show(const ViewportContext& context);

    // The scene of the last frame; null: there is nothing to show.
    const std::shared_ptr<const render::Scene>& scene() const { return shown_; }
    render::Camera camera() const { return controller_.orbit().camera(); }
    render::Light light() const { return light_; }
    bool is_focused() const { return is_focused_; }
    bool is_over() const { return is_over_; }  // the cursor, in the last frame

    // Projects a 3D point (m) to px of the window; none: the point is behind the eye.
    std::optional<Vec2f> world_to_px(const Vec3f& x) const;

    ViewportController& controller() { return controller_; }
    const ViewportController& controller() const { return controller_; }

 private:
    // Key of the last rendering that was requested.
    struct Drawn {
        std::shared_ptr<const render::Scene> scene;
        CameraPose standpoint;
        int width_px = 0;
        int height_px = 0;
        UiTexture texture = 0;

        bool operator==(const Drawn&) const = default;
    };

    ViewportInput take_input(const ViewportContext& context);
    void show_badge_button(const ViewportContext& context);
    bool wants_curved(const Workspace& workspace) const;
    void make_scene(const ViewportContext& context);
    void request_rendering(const ViewportContext& context);
    std::optional<int> next_sample(const ViewportContext& context);
    void choose_cursor(const ViewportContext& context) const;

    ViewportColours colours_;
    ViewportController controller_;
    CurvedDrape curved_;
    ViewportScene scene_;
    std::shared_ptr<const render::Scene> shown_;
    render::Light light_;
    Drawn drawn_;
    int frames_at_rest_ = 0;  // since the last rendering, as far as they matter
    Vec2f low_px_{0, 0};      // upper left corner of the view in the window
    Vec2f size_px_{1, 1};
    bool is_focused_ = false;
    bool is_over_ = false;
};

}  // namespace selvedge::editor
