#pragma once
// The colours of the 3D view, but for cloth and body.
#include <array>

#include "render/scene/scene.h"

namespace selvedge {

struct FittingColours {
    Background background{};          // the picture renderer's own paper grey
    Rgb8 selected{0x1E, 0x9C, 0xC8};  // outlines of what is selected: the interface's accent, lighter
    Rgb8 hovered{0x86, 0xC9, 0xDE};   // the same, lighter
    Rgb8 error{0xC2, 0x3B, 0x30};     // places that a message names
    Rgb8 point{0x5B, 0x86, 0xA8};     // arrangement points
    Rgb8 hovered_point{0xE0, 0x8A, 0x2C};
    Rgb8 pin{0xC9, 0x4F, 0x46};  // heads of pins
    Rgb8 needle{0x8A, 0x8D, 0x91};
    Rgb8 pull{0xE0, 0x8A, 0x2C};                                                             // the hand that pulls
    std::array<Rgb8, 3> axes{{{0xC2, 0x5A, 0x4E}, {0x4F, 0x8F, 0x5A}, {0x45, 0x74, 0xB2}}};  // x, y, z
    Rgb8 held_axis{0xE0, 0x8A, 0x2C};  // the handle that is under the cursor or held
    Rgb8 ink{0x26, 0x29, 0x2E};        // words
    Rgb8 faint{0x77, 0x78, 0x7A};
    Rgb8 badge{0xFB, 0xFA, 0xF8};  // behind words
    Rgb8 badge_line{0xD5, 0xD2, 0xCB};
    Rgb8 good{0x3F, 0x86, 0x5B};  // of the badge's dot: settled,
    Rgb8 busy{0xD0, 0x8B, 0x2E};  // sewing and draping
};

}  // namespace selvedge
