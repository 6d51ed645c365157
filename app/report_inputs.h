#pragma once
// The files that a garment is dressed from, with their hashes, for its report.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/garment_options.h"
#include "app/options.h"
#include "sim/core/sha256.h"
#include "sim/dress/report.h"
#include "sim/pattern/pattern.h"

namespace selvedge::app {

using FileHash = std::function<std::string(const std::filesystem::path&)>;

// In this order: the garment, those over it, the body, and the files of fabrics, tartans and pictures that the pattern
// or the options name. What ships in the program is no file. hash: of a file's content. Throws InputError if one cannot
// be read.
std::vector<sim::ReportInput> report_inputs(const GarmentOptions& options, const BodyOptions& body,
                                            const sim::Pattern& pattern, const FileHash& hash = sim::sha256_of_file);

}  // namespace selvedge::app
