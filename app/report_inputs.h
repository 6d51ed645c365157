#pragma once
// The files that a garment is dressed from, with their hashes, for its report.
#include <string>
#include <vector>

#include "app/garment_options.h"
#include "app/options.h"
#include "sim/inspection/report.h"
#include "sim/pattern/pattern.h"

namespace selvedge::app {

// In this order: the garment, those over it, the body with the buffers of a .gltf, the motion, and the files of fabrics
// and pictures. What ships in the program is no file; a mannequin is the text of its measurements. shown: the pattern
// with the fabric and the design of the options, as name_inputs() makes it. motion: its file; empty: none. Throws
// InputError if one cannot be read.
std::vector<sim::ReportInput> report_inputs(const GarmentOptions& options, const BodyOptions& body,
                                            const sim::Pattern& shown, const std::string& motion = {});

}  // namespace selvedge::app
