#pragma once
// All faults of a garment, as the command check lists them: those of its file, and what the command dress refuses.
#include <filesystem>
#include <string>
#include <vector>

#include "sim/pattern/fault.h"
#include "sim/pattern/pattern.h"

namespace selvedge::render {

// Of a file. Does not throw InputError.
std::vector<sim::Fault> faults_of_file(const std::filesystem::path& path);

// Adds what dress would refuse (dress_faults()), those of the tartan that the pattern names, and then, if no fault is
// an error, of its surface designs. file: its name in the faults.
void add_faults_of_dressing(const sim::Pattern& pattern, const std::string& file, std::vector<sim::Fault>& faults);

}  // namespace selvedge::render
