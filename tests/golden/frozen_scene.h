#pragma once
// The scene of the golden pictures, made by formula so that nothing but the renderer can change them: a square of cloth
// laid over a ball, its rim hanging in folds, cut in two panels with a seam between.
#include "render/scene/scene.h"

namespace selvedge::test {

struct FrozenOptions {
    render::View view = render::View::ThreeQuarter;
    render::ShowMode show = render::ShowMode::Tartan;
    bool has_ball = true;
};

render::Scene make_frozen_scene(const FrozenOptions& options = {});

}  // namespace selvedge::test
