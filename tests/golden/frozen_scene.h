#pragma once
// The scene of the golden pictures, made by formulas so that only the renderer can change the pictures: a square of
// cloth draped over a ball, its border hanging in folds, cut into two panels with a seam between them.
#include "render/marks/legend.h"
#include "render/scene/scene.h"

namespace selvedge::test {

struct FrozenOptions {
    render::View view = render::View::ThreeQuarter;
    render::ShowMode show = render::ShowMode::Tartan;
    bool has_ball = true;
};

render::Scene make_frozen_scene(const FrozenOptions& options = {});

// The frozen scene in the modes that use paint and marks, with values computed by formulas.

struct FrozenMode {
    render::Scene scene;
    std::optional<render::Legend> legend;
};

FrozenMode make_frozen_mode(render::ShowMode mode);

// With the legend in the lower left corner.
render::Image draw_frozen(const FrozenMode& frozen, int side_px);

}  // namespace selvedge::test
