#pragma once
// What came of a batch, gathered from the folders of its jobs: results.jsonl and results.csv, whose bytes follow from
// the inputs alone, whatever did the jobs and in which order; and times.csv, which tells what they took.
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "batch/job.h"
#include "sim/core/json.h"

namespace selvedge::batch {

// One row for each finished job, in the order of the jobs: see docs/batch.md.
struct Results {
    std::vector<sim::Json> rows;
    std::vector<std::string> missing;  // jobs that are not done, or were done with other inputs
};

// key_of: that of a job as it is now (BatchWork). Throws InputError if a finished job has no readable report.
Results gather_results(const std::vector<Job>& jobs, const std::filesystem::path& output,
                       const std::function<std::string(const Job&)>& key_of);

// Of a row: why it was refused or failed, or the cause of the first fault that makes the outcome what it is; empty if
// it has none.
std::string first_cause(const sim::Json& row);

// Writes results.jsonl, results.csv and times.csv. Throws InputError.
void write_results(const Results& results, const std::filesystem::path& output);

}  // namespace selvedge::batch
