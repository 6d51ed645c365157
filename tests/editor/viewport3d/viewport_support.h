#pragma once
// A small workspace for tests of the 3D view: one square panel in front of a small body, and a controller with
// simulated input.
#include <optional>
#include <string>

#include "editor/viewport3d/viewport_controller.h"

namespace selvedge::editor {

// A panel of 40 x 40 cm, "square"; its centre is at (0, 1, 0.3), facing the front.
sim::Pattern square_pattern();

// A cube of 20 cm, centred at (0, 1, 0), with the arrangement points "before" and "behind".
CurrentBody small_body(const std::string& text);

class ViewportFixture {
 public:
    explicit ViewportFixture(const sim::Pattern& pattern = square_pattern(), BodyMaker maker = small_body);

    Workspace& workspace() { return workspace_; }
    const Document& document() const { return *workspace_.document; }
    ViewportController& controller() { return controller_; }
    const sim::Panel& panel(std::size_t index = 0) const { return document().pattern().panels[index]; }

    Vec2f seen(const Vec3f& x) const { return px_of(controller_.viewing(), x).value(); }

    // One frame each. The cursor keeps its last position.
    void rest() { step({}); }
    void move_to(const Vec2f& px);
    void press(MouseButton button = MouseButton::Left);
    void release(MouseButton button = MouseButton::Left);
    void click(const Vec2f& px);
    void key(Key key);
    void type(const std::string& text);

    Modifiers modifiers{};
    ClothChoice choice = ClothChoice::Panels;

 private:
    void step(ViewportInput input);

    Workspace workspace_;
    ViewportController controller_;
    Vec2f cursor_{2, 2};
};

}  // namespace selvedge::editor
