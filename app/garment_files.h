#pragma once
// Options of dress that ask for the files of a dressed garment.
#include <filesystem>
#include <string>
#include <vector>

#include "app/picture.h"
#include "render/output/garment_files.h"

namespace selvedge::app {

class Command;

using render::GarmentFileOptions;
using render::GarmentFiles;

// Adds --export, --texture-size, --no-textures, --with-body, --thickness, --export-surface and --export-garmentcode,
// and validates them while parsing. Pre: the command has --surface. `options` must outlive the parsing.
void add_garment_file_options(Command& command, GarmentFileOptions& options);

// Throws InputError if a file cannot be written, or its format cannot hold what is asked for.
void check_garment_files(const GarmentFileOptions& options);

// All files that may be written, those beside others included. garment: the file that is dressed.
std::vector<std::filesystem::path> outputs_of(const GarmentFileOptions& options, const std::filesystem::path& garment);

// The name of a garment's element of GarmentCodeData: "rand_12" of rand_12_specification.json and of rand_12.json.
std::string element_name(const std::filesystem::path& garment);

}  // namespace selvedge::app
