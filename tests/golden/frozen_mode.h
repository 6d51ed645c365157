#pragma once
// The frozen scene in the modes that use paint and marks, with values computed by formulas.
#include "render/marks/legend.h"
#include "tests/golden/frozen_scene.h"

namespace selvedge::test {

struct FrozenMode {
    render::Scene scene;
    std::optional<render::Legend> legend;
};

FrozenMode make_frozen_mode(render::ShowMode mode);

// With the legend in the lower left corner.
render::Image draw_frozen(const FrozenMode& frozen, int side_px);

}  // namespace selvedge::test
