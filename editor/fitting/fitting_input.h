#pragma once
// What mouse and keys do to the 3D view in one frame. Positions are px from the view's upper left.
#include <array>
#include <string>
#include <vector>

#include "editor/frame/input.h"
#include "sim/core/vec.h"

namespace selvedge {

struct ButtonInput {
    bool is_down = false;
    bool was_pressed = false;   // in this frame, over the view
    bool was_released = false;  // in this frame, anywhere
};

struct FittingInput {
    Vec2f size_px{1, 1};  // of the view
    float scale = 1;      // of the interface
    float seconds = 0;    // since the last frame
    Vec2f cursor_px{0, 0};
    bool is_over = false;                  // the cursor is over the view, and nothing lies between
    std::array<ButtonInput, 3> buttons{};  // by MouseButton
    float wheel = 0;                       // notches, over the view
    Modifiers modifiers{};
    std::vector<Key> keys{};  // pressed in this frame; none while a text is being typed elsewhere
    std::string text{};       // typed in this frame, the same

    const ButtonInput& button(MouseButton which) const { return buttons[static_cast<std::size_t>(which)]; }
};

}  // namespace selvedge
