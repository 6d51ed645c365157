#pragma once
// From a garment and a body to a picture: the options that dress and render share, and the drawing.
#include <CLI/CLI.hpp>
#include <optional>

#include "render/image/image.h"
#include "render/scene/scene.h"
#include "sim/body/body.h"
#include "sim/mesh/plain_mesh.h"
#include "sim/tartan/sett.h"

namespace selvedge {

enum class Framing { All, Garment };

struct PictureOptions {
    int width_px = 1024;
    int height_px = 1024;
    View view = View::Front;
    Framing framing = Framing::All;
    ShowMode show = ShowMode::Tartan;
    std::optional<Sett> sett;             // none: kDefaultTartan
    std::optional<double> sett_size;      // m, of one repeat; none: the tartan's own
    Vec2d sett_position = Vec2d::Zero();  // m, (weft, warp)
    bool is_transparent = false;
};

// Adds --size, --view, --frame, --show, --tartan, --sett-size, --sett-position and --transparent. What they are given
// is checked while the command line is read, before any work. `options` must outlive the command line.
void add_picture_options(CLI::App& command, PictureOptions& options);

// What the cloth is drawn in: the tartan that was asked for, at the size that was asked for.
Sett sett_of(const PictureOptions& options);

// Throws InputError when there is no way to draw (render/gl/context.h): to be asked before long work.
void check_can_draw();

// The garment alone when body is null. Triangles with numbers that are not finite are left out. Throws InputError when
// nothing is left to draw, or there is no way to draw (render/gl/context.h).
Image draw_picture(const PlainMesh& garment, const Body* body, const PictureOptions& options);

}  // namespace selvedge
