#pragma once
// What a picture shows and from where: the scene, with its camera set so that it holds the figure and leaves room for
// the legend.
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
    render::Corner corner = render::Corner::LowerLeft;  // where it is drawn
    Vec3f axis = Vec3f::Zero();                         // an upright through it is what the figure turns about
};

// For a figure that turns by these angles (rad): it stays in the picture, and clear of the legend, at all of them.
// Throws InputError when nothing is left to draw, or the mode asks for what is not there.
Layout compose(const RenderSubject& sitter, const PictureOptions& options, const std::vector<float>& turns = {0});

// The scene after a turn, its lights with the camera.
render::Scene turned(const Layout& layout, const PictureOptions& options, float angle);

// One picture of the scene, with the legend.
render::RenderOptions render_options(const PictureOptions& options);

}  // namespace selvedge::app
