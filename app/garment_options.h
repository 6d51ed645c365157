#pragma once
// Command-line options that say which garment is dressed and how: of dress and animate.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "app/options.h"
#include "app/picture.h"
#include "sim/dress/dress_limits.h"
#include "sim/dress/dress_options.h"
#include "sim/inspection/report.h"
#include "sim/pattern/fault.h"
#include "sim/pattern/pattern.h"

namespace selvedge::app {

struct GarmentOptions {
    std::filesystem::path garment;
    std::vector<std::filesystem::path> over;  // garments that are worn over it, from the inside out
    std::string fabric;                       // empty: the pattern's
    sim::DressOptions dress;
    std::optional<int> threads;        // none: one per CPU core
    bool coarsens_back_faces = false;  // of the mesh, as the picture sees it
    bool is_quiet = false;
    std::vector<std::filesystem::path> named{};  // files that the garments and options name; set by name_inputs()
};

// `options` must outlive the parsing.
void add_garment_options(Command& command, GarmentOptions& options);
void add_thread_options(Command& command, GarmentOptions& options);

// The garment with those over it, from their files. Throws InputError, for what dress_faults() finds too.
sim::Pattern load_garments(const GarmentOptions& options, std::vector<std::string>& notes);

// The files that are read: the garment and those over it, and the body's, if it is a file; after name_inputs() all
// others too, such as fabrics and pictures.
std::vector<std::filesystem::path> input_files(const GarmentOptions& options, const BodyOptions& body);

// Takes from the pattern what the command line does not name: the body, and the fabrics and designs of the panels. None
// of their files is read.
void name_inputs(GarmentOptions& options, BodyOptions& body, PictureOptions& picture, const sim::Pattern& pattern);

// Reads fabrics and designs, and takes from the pattern how the cloth is drawn where the command line does not say.
// Tells the dressing from where the picture sees the cloth, if back faces are to be coarse. Pre: name_inputs(). Throws
// InputError.
void fill_in(GarmentOptions& options, PictureOptions& picture, const sim::Pattern& pattern);

// Tells what was found while a garment was read, as notes on stderr.
void tell_warnings(const std::vector<sim::Fault>& warnings);

// One line each, to standard output.
void print_faults(const sim::DressReport& report);

}  // namespace selvedge::app
