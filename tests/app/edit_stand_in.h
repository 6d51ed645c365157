#pragma once
// A stand-in for the editor in tests of its host: ImGui's demo window beside a scene, a button that counts its clicks,
// and a text field.
#include "app/edit_loop.h"
#include "editor/ui/ui_input.h"

struct ImGuiContext;

namespace selvedge::app {

class FakeEditor : public EditSurface {
 public:
    // Rotates the scene's camera by `turn` (rad) each frame.
    explicit FakeEditor(render::Scene scene, float turn = 0, const std::string& font = {}, bool is_preview = true);
    ~FakeEditor() override;

    editor::FrameOutput frame(const FrameInput& input) override;

    int presses() const { return presses_; }
    std::string typed() const { return typed_.data(); }
    bool was_asked_to_close() const { return was_asked_to_close_; }

    static constexpr float kButtonX = 60, kButtonY = 700, kBoxX = 300;  // inside the two widgets, px at scale 1

 private:
    void fill();
    editor::SceneRequest scene_to_draw();

    ImGuiContext* context_;
    editor::UiInput input_;
    std::shared_ptr<const render::Scene> scene_;
    render::Camera camera_;
    float turn_;
    bool is_preview_;
    int frames_ = 0;
    int presses_ = 0;
    std::array<char, 64> typed_{};
    bool was_asked_to_close_ = false;
};

}  // namespace selvedge::app
