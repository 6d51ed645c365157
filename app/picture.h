#pragma once
// From a garment and a body to a picture: the options that dress and render share, and the drawing.
#include <optional>

#include "app/options.h"
#include "render/image/image.h"
#include "render/scene/scene.h"
#include "sim/body/body.h"
#include "sim/mesh/plain_mesh.h"
#include "sim/pattern/fabric.h"
#include "sim/tartan/sett.h"

namespace CLI {
class App;
}

namespace selvedge::app {

enum class Framing { All, Garment };

struct PictureOptions {
    int width_px = 1024;
    int height_px = 1024;
    int samples = 4;
    int supersample = 1;
    std::optional<render::View> view;    // none: from the front; a hierarchy from above
    std::optional<CameraChoice> camera;  // instead of a view
    Framing framing = Framing::All;
    render::ShowMode show = render::ShowMode::Tartan;
    std::optional<sim::Sett> sett;       // none: kDefaultTartan
    std::optional<double> sett_size;     // m, of one repeat; none: the tartan's own
    std::optional<Vec2d> sett_position;  // m, (weft, warp); none: zero
    bool is_transparent = false;
    render::Material material{};  // how the cloth takes light
    SurfaceChoice surface{};      // the cloth's own triangles, or curved ones over them
};

// Adds --size, --samples, --supersample, --view, --camera, --frame, --show, --tartan, --sett-size, --sett-position,
// --transparent and those of surfaces. What they are given is checked while the command line is read, before any work.
// `options` must outlive the command line.
void add_picture_options(CLI::App& command, PictureOptions& options);

// What the cloth is drawn in: the tartan that was asked for, at the size that was asked for.
sim::Sett chosen_sett(const PictureOptions& options);

// Throws InputError when there is no way to draw (render/gl/context.h), or none with so many samples: to be asked
// before long work.
void check_can_draw(const PictureOptions& options = {});

// Who is drawn. What is null is not there.
struct RenderSubject {
    const sim::PlainMesh& garment;
    const sim::Body* body = nullptr;
    const sim::TriangleHierarchy* hierarchy = nullptr;
};

// Throws InputError when the mode asks for a body or a hierarchy that will not be there: to be asked before long work.
void check_can_show(render::ShowMode show, bool has_body, bool has_hierarchy);

// Triangles with numbers that are not finite are left out. Throws InputError when nothing is left to draw, there is no
// way to draw (render/gl/context.h), or the mode asks for what is not there.
render::Image draw_picture(const RenderSubject& sitter, const PictureOptions& options);

}  // namespace selvedge::app
