#pragma once
// The list of a batch's jobs: from a manifest, a JSON or CSV file (docs/batch.md), or as a product of garments, bodies
// and fabrics.
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "batch/job.h"

namespace selvedge::batch {

inline constexpr std::size_t kMostJobs = 1'000'000;

// Every garment on every body in every fabric. Empty bodies or fabrics: those of the patterns.
struct Product {
    std::vector<std::string> garments;  // files, or patterns of names: patterns/*.json
    std::vector<std::string>
        bodies;  // mannequin[:...], files, patterns of names, or .txt files with one of them a line
    std::vector<std::string> fabrics;  // shipped fabrics or files
    std::vector<JobOption> options;    // of all jobs
};

// Relative paths are relative to `folder`. Throws InputError if a pattern of names finds no file, or for over
// kMostJobs.
std::vector<Job> jobs_of(const Product& product, const std::filesystem::path& folder);

// By the extension, .csv or else JSON; relative paths in it are relative to its folder. Throws InputError with file and
// place.
std::vector<Job> read_manifest(const std::filesystem::path& path);

// text: of a manifest called `file`; `extension`: ".csv" or ".json".
std::vector<Job> parse_manifest(std::string_view text, const std::filesystem::path& file);

// "seconds=8" or "no-self-collision". Throws InputError for an option that a job cannot have: an output, what has a
// place of its own, or a name or value that could be read as another option.
JobOption parse_option(const std::string& text);

// Sorts the jobs by name and gives unnamed ones theirs; where these would be equal, with a hash of what the job is.
// Throws InputError for two jobs of one name, and for two unnamed jobs that are the same.
void name_jobs(std::vector<Job>& jobs);

}  // namespace selvedge::batch
