#pragma once
// The files that a garment is dressed from, with their hashes, for its report.
#include <vector>

#include "app/garment_options.h"
#include "app/options.h"
#include "sim/dress/report.h"
#include "sim/pattern/pattern.h"

namespace selvedge::app {

// In this order: the garment, those over it, the body, and the files of fabrics, tartans and pictures that the pattern
// or the options name. What ships in the program is no file. Throws InputError if one cannot be read.
std::vector<sim::ReportInput> report_inputs(const GarmentOptions& options, const BodyOptions& body,
                                            const sim::Pattern& pattern);

}  // namespace selvedge::app
