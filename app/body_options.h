#pragma once
// The body that a garment is put on: a mannequin from measurements, or a file that others made. Shared by dress and
// render.
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/load_body.h"

namespace selvedge {

struct BodyOptions {
    std::string source;  // "mannequin[:bust=92,...]" or a file; empty: none was named
    LoadBodyOptions load;

    bool is_file() const;
};

struct NotedBody {
    Body body;
    std::vector<std::string> notes;  // what could not be met, or was changed, a sentence each
};

// Adds -b,--body, --body-unit and --body-up. A mannequin's measures are checked while the command line is read.
// `options` must outlive the command line.
void add_body_options(CLI::App& command, BodyOptions& options, const std::string& help);

// Pre: a source is named. Throws InputError as make_mannequin and load_body do.
NotedBody make_body(const BodyOptions& options);

}  // namespace selvedge
