#pragma once
// The folder of one job: OUTPUT/jobs/NAME. It appears whole when the job is done, so that a kill at any moment loses no
// result and leaves no half of one. It holds report.json, job.json (JobRecord), times.json, log.txt, and what else was
// asked for.
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "batch/file_lock.h"
#include "sim/core/json.h"

namespace selvedge::batch {

namespace job_file {
inline constexpr std::string_view kReport = "report.json";
inline constexpr std::string_view kRecord = "job.json";
inline constexpr std::string_view kTimes = "times.json";
inline constexpr std::string_view kLog = "log.txt";
inline constexpr std::string_view kPicture = "picture.png";
inline constexpr std::string_view kThumbnail = "thumbnail.png";
}  // namespace job_file

// What is known of a job that was done.
struct JobRecord {
    std::string key;  // of the inputs, the options, the outputs and the program: equal for equal results
    int exit_code = 0;
    bool has_failed = false;  // for a reason that may pass, such as a time limit: is tried again by the next run
    double wall_s = 0;
    double cpu_s = 0;
    double peak_memory_mb = 0;
};

std::filesystem::path job_folder(const std::filesystem::path& output, const std::string& name);

// The record of a finished job; nullopt if there is none, or if it is broken.
std::optional<JobRecord> read_record(const std::filesystem::path& output, const std::string& name);

// What a finished job left.
struct JobResult {
    JobRecord record;
    sim::Json report;
};
// Nullopt if there is none with this key, or if its record or its report cannot be read.
std::optional<JobResult> read_result(const std::filesystem::path& output, const std::string& name,
                                     const std::string& key);

// The report in a job's folder, and its outcome; nullopt if there is no readable one.
std::optional<sim::Json> read_report(const std::filesystem::path& folder);
std::string outcome_in(const sim::Json& report);  // empty if it names none

// A folder in which a job is being done. Its name is its own, and it is locked, so that no other process takes it for
// one that was left behind. Without finish(), the destructor deletes it.
class UnfinishedJob {
 public:
    // Throws InputError if the folder cannot be made.
    UnfinishedJob(const std::filesystem::path& output, const std::string& name);
    ~UnfinishedJob();
    UnfinishedJob(const UnfinishedJob&) = delete;
    UnfinishedJob& operator=(const UnfinishedJob&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path file(std::string_view name) const { return path_ / name; }

    // Writes the record and puts the folder in its place, instead of an older one. Throws InputError.
    void finish(const JobRecord& record);

 private:
    std::filesystem::path target_;
    std::filesystem::path path_;
    std::optional<FileLock> lock_;  // none if there are too many open files
};

// Deletes what killed runs left of unfinished jobs: of those with the names `own`, which no other process does now, and
// of others if they are older than any job may take. An older result that was being replaced takes its place again.
// Pre: this process does no job now.
void delete_strays(const std::filesystem::path& output, const std::set<std::string>& own);

}  // namespace selvedge::batch
