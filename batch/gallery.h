#pragma once
// The gallery of a batch: OUTPUT/index.html, one page that shows all jobs with their pictures, faults and fit, and
// sorts, filters and compares them. It works without a server.
#include <filesystem>
#include <string>
#include <vector>

#include "batch/compare.h"
#include "sim/core/json.h"

namespace selvedge::batch {

// rows: of gather_results(). changes: of compare_runs(), one per row; empty without an earlier run.
std::string gallery_html(const std::vector<sim::Json>& rows, const std::vector<JobChange>& changes);

// Throws InputError.
void write_gallery(const std::vector<sim::Json>& rows, const std::vector<JobChange>& changes,
                   const std::filesystem::path& output);

}  // namespace selvedge::batch
