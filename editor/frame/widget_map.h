#pragma once
// Where named controls stand on the screen, so that scripts and tests can click them by name.
#include <map>
#include <string>

#include "sim/core/vec.h"

namespace selvedge {

struct WidgetBox {
    Vec2f low{0, 0};  // px of the framebuffer, upper left
    Vec2f high{0, 0};

    Vec2f centre() const { return (low + high) / 2; }
};

// As of the last frame.
using WidgetMap = std::map<std::string, WidgetBox>;

}  // namespace selvedge
