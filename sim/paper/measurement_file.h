#pragma once
// Files of body measurements: FreeSewing's (YAML or JSON), individual and multisize files of Valentina and Seamly2D
// (XML: .vit, .vst, .smis, .smms), and GarmentCode's body (YAML). Told by content, not by extension.
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/paper/drawing.h"

namespace selvedge::sim {

enum class MeasuredSex { Unknown, Female, Male };

struct MeasurementFile {
    std::string format;  // "FreeSewing", "Valentina", "GarmentCode", for reports
    std::vector<Measurement> lengths = {};
    MeasuredSex sex = MeasuredSex::Unknown;  // as the file says
    std::vector<std::string> notes = {};     // guesses, and what was left out, one line each
};

// Throws InputError (with the line where the format has it) for other files, broken ones, and those beyond the limits
// (1 MB, 2,000 measurements).
MeasurementFile parse_measurements(std::string_view text, const std::string& file);
MeasurementFile read_measurements(const std::filesystem::path& path);

}  // namespace selvedge::sim
