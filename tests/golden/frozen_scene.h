#pragma once
// The scene of the golden pictures, made by formulas so that only the renderer can change the pictures: a square of
// cloth draped over a ball, its border hanging in folds, cut into two panels with a seam between them.
#include "render/scene/scene.h"

namespace selvedge::test {

struct FrozenOptions {
    render::View view = render::View::ThreeQuarter;
    render::ShowMode show = render::ShowMode::Tartan;
    bool has_ball = true;
};

render::Scene make_frozen_scene(const FrozenOptions& options = {});

}  // namespace selvedge::test
