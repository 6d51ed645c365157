#pragma once
// The frozen scene in the modes that paint and mark, with figures made by formula.
#include "render/marks/legend.h"
#include "tests/golden/frozen_scene.h"

namespace selvedge {

struct FrozenMode {
    Scene scene;
    std::optional<Legend> legend;
};

FrozenMode make_frozen_mode(ShowMode mode);

// With the legend, in the lower left.
Image draw_frozen(const FrozenMode& frozen, int side_px);

}  // namespace selvedge
