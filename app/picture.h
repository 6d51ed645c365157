#pragma once
// Command-line options of pictures, which dress, render and animate share. What they mean: render/output/picture.h.
#include "app/options.h"
#include "render/output/picture.h"

namespace selvedge::app {

class Command;

using render::PictureOptions;
using render::RenderSubject;

// Adds --size, --samples, --supersample, --view, --camera, --frame, --show, --tartan, --design, --sett-size,
// --sett-position, --transparent and the surface options. Validates all values while parsing. `options` must outlive
// the parsing.
void add_picture_options(Command& command, PictureOptions& options);

}  // namespace selvedge::app
