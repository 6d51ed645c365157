#pragma once
// The layout of a picture: builds the scene, and chooses camera and legend corner so that the subject is framed and the
// legend does not cover it.
#include <optional>
#include <vector>

#include "app/picture.h"
#include "render/draw/renderer.h"
#include "render/marks/legend.h"
#include "render/scene/scene.h"

namespace selvedge::app {

struct Layout {
    render::Scene scene;
    std::optional<render::Legend> legend;
    render::Corner corner = render::Corner::LowerLeft;  // the legend's corner
    Vec3f axis = Vec3f::Zero();                         // a point on the vertical axis that the subject rotates about
};

// Frames a subject that rotates by these angles (rad): at each angle it stays in the picture and clear of the legend.
// Throws InputError if nothing is left to draw or the mode requires data that is missing.
Layout compose(const RenderSubject& subject, const PictureOptions& options, const std::vector<float>& turns = {0});

// The scene after a turn by `angle` (rad); the lights keep their direction relative to the camera.
render::Scene turned(const Layout& layout, const PictureOptions& options, float angle);

// Render options for one picture of the scene.
render::RenderOptions render_options(const PictureOptions& options);

}  // namespace selvedge::app
