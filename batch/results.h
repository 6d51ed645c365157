#pragma once
// What came of a batch, gathered from the folders of its jobs: results.jsonl and results.csv, whose bytes follow from
// the inputs alone, whatever did the jobs and in which order; and times.csv, which tells what they took.
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "batch/job.h"
#include "sim/core/json.h"

namespace selvedge::batch {

// One row for each finished job, in the order of the jobs: see docs/batch.md.
struct Results {
    std::vector<sim::Json> rows;
    std::vector<std::string> missing;  // not done, or with other inputs, or their result cannot be read
};

// What a batch writes into its output folder beside those of the jobs.
namespace result_file {
inline constexpr std::string_view kLines = "results.jsonl";
inline constexpr std::string_view kTable = "results.csv";
inline constexpr std::string_view kTimes = "times.csv";
inline constexpr std::string_view kGallery = "index.html";
}  // namespace result_file
std::vector<std::filesystem::path> result_files(const std::filesystem::path& output);

// key_of: that of a job as it is now (BatchWork).
Results gather_results(const std::vector<Job>& jobs, const std::filesystem::path& output,
                       const std::function<std::string(const Job&)>& key_of);

// A member of a row or of a part of it; null if it has none.
sim::Json member_of(const sim::Json& object, std::string_view name);

// Of a row: why it was refused or failed, or the cause of the first fault that makes the outcome what it is; empty if
// it has none.
std::string first_cause(const sim::Json& row);

// Writes results.jsonl, results.csv and times.csv. Throws InputError.
void write_results(const Results& results, const std::filesystem::path& output);

}  // namespace selvedge::batch
