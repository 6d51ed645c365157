#pragma once
// --turntable: a film of the figure turning once about its upright, before a camera and lights that stand.
#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/picture.h"
#include "sim/core/progress.h"

namespace selvedge {

struct TurntableOptions {
    std::filesystem::path file;  // empty: no film is wanted
    int frames = 100;            // of one turn; the one after the last would be the first
    int frames_per_second = 25;
};

// Adds --turntable, --frames and --fps. `options` must outlive the command line.
void add_turntable_options(CLI::App& command, TurntableOptions& options);

// Throws InputError when the film cannot be written or is at odds with the picture's options: to be asked before long
// work. Without a file all is well.
void check_turntable(const TurntableOptions& options, const PictureOptions& picture);

// The frame is one for all angles, and holds the figure at each. Throws InputError as draw_picture does, and when the
// film cannot be written.
void write_turntable(const Sitter& sitter, const PictureOptions& picture, const TurntableOptions& options,
                     const Progress& progress = {});

}  // namespace selvedge
