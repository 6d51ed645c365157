#pragma once
// The scene of the golden pictures, made by formula so that nothing but the renderer can change them: a square of cloth
// laid over a ball, its rim hanging in folds, cut in two panels with a seam between.
#include "render/scene/scene.h"

namespace selvedge {

struct FrozenOptions {
    View view = View::ThreeQuarter;
    ShowMode show = ShowMode::Tartan;
    bool has_ball = true;
};

Scene make_frozen_scene(const FrozenOptions& options = {});

}  // namespace selvedge
