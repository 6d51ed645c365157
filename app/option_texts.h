#pragma once
// Options of subcommands from texts such as "--show=strain", for callers without a command line, such as the Python
// module and the batch: so they have the same names, limits and errors. Each throws InputError for what the command
// line would refuse.
#include <string>
#include <vector>

#include "app/animation_run.h"
#include "app/dress_command.h"
#include "app/garment_files.h"
#include "app/options.h"
#include "app/picture.h"

namespace selvedge::app {

DressArguments read_dress_options(const std::vector<std::string>& texts);
PictureOptions read_picture_options(const std::vector<std::string>& texts);
BodyOptions read_body_options(const std::vector<std::string>& texts);

struct ExportOptions {
    PictureOptions picture;
    GarmentFileOptions files;
};
ExportOptions read_export_options(const std::vector<std::string>& texts);

// Those of animate that are not of the garment and the body.
AnimateArguments read_animation_options(const std::vector<std::string>& texts);

}  // namespace selvedge::app
