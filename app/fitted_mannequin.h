#pragma once
// From a file of measurements to a mannequin, with the list of what was used; for the commands mannequin and import.
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "sim/mannequin/from_measurements.h"
#include "sim/paper/drawing.h"

namespace selvedge::app {

struct FittedMannequin {
    sim::MannequinFit fit;
    std::vector<std::string> lines;  // what was used, what follows, what is guessed and left out, for people
};

// Throws InputError; `path` is in the message.
FittedMannequin read_fitted_mannequin(const std::filesystem::path& path);

// From the measurements that a drawing of this name carries.
FittedMannequin fitted_mannequin(std::span<const sim::Measurement> measurements, const std::string& name);

}  // namespace selvedge::app
