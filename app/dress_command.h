#pragma once
// What the command dress does, for others who dress as it does: the batch.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/film.h"
#include "app/garment_files.h"
#include "app/garment_options.h"
#include "app/last_body.h"
#include "app/options.h"
#include "app/picture.h"
#include "sim/core/content_store.h"

namespace selvedge::app {

class Command;

struct DressArguments {
    GarmentOptions garment;
    BodyOptions body;
    PictureOptions picture;
    TurntableOptions turntable;
    std::filesystem::path picture_file;  // empty: no such output
    std::filesystem::path report_file;
    std::filesystem::path times_file;  // empty: the times are in the report
    GarmentFileOptions exports;
    std::vector<std::filesystem::path> body_files;
};

// Adds all options of the command dress, and validates their values while parsing. `arguments` must outlive the
// parsing.
void add_dress_options(Command& command, DressArguments& arguments);

// Where what a dressing needs of its body may be found; null for none of them.
struct KnownBodies {
    const sim::ContentStore* store = nullptr;  // keeps bodies and their fields
    const LastBody* ready = nullptr;
};

// Dresses, writes and prints; returns the exit code. Throws InputError for wrong input, which it has then written into
// the report, and PassingError without one.
int run_dress(DressArguments arguments, const KnownBodies& known = {});

}  // namespace selvedge::app
