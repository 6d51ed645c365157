#include "batch/run.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <thread>
#include <utility>

#include "batch/file_lock.h"
#include "batch/job_folder.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/file_path.h"
#include "sim/core/json.h"
#include "sim/core/printable.h"
#include "sim/inspection/report.h"

namespace selvedge::batch {
namespace {

using Path = std::filesystem::path;
using Clock = std::chrono::steady_clock;

constexpr auto kPulse = std::chrono::milliseconds(200);  // between two reports of progress

// The file stays: to delete it would let two runs lock two files of one name.
Path lock_file(const BatchOptions& options) {
    return options.output /
           (".lock-" + std::to_string(options.shard.index) + "-of-" + std::to_string(options.shard.count));
}

// The last line of a text file, of which no more than its end is read; empty if there is none.
std::string last_line(const Path& log) {
    constexpr std::streamoff kMost = 4096;  // bytes
    std::ifstream file(log, std::ios::binary | std::ios::ate);
    const std::streamoff size = file.tellg();
    file.seekg(std::max(std::streamoff(0), size - kMost));
    std::ostringstream content;
    content << file.rdbuf();
    std::string text = content.str();
    while (text.ends_with('\n')) text.pop_back();
    return sim::printable(text.substr(text.rfind('\n') + 1));
}

std::string failure_of(const WorkResult& result, const JobLimits& limits, const Path& log) {
    switch (result.end) {
        case WorkEnd::Crashed:
            return std::string("its process was ended by a signal: ") + ::strsignal(result.signal);
        case WorkEnd::TimedOut:
            return "it took longer than " + std::to_string(std::lround(limits.seconds)) + " s";
        case WorkEnd::OutOfMemory:
            return "it needs more memory than it may have";
        case WorkEnd::Exited:
            break;
    }
    const std::string said = result.code == 0 ? "" : last_line(log);
    if (!said.empty()) return said;
    return "its process ended with exit code " + std::to_string(result.code) + " and left no report of that";
}

// Whether the exit code says what the report does. It does not where a file could not be written after the report, and
// there is no report of what went wrong before the garment was read.
bool is_outcome(const sim::Json& report, int exit_code) {
    const std::string outcome = outcome_in(report);
    constexpr std::array kAll{sim::Outcome::Dressed, sim::Outcome::DoesNotFit, sim::Outcome::Defect,
                              sim::Outcome::Refused};
    return std::ranges::any_of(
        kAll, [&](sim::Outcome one) { return outcome == name_of(one) && exit_code == exit_code_of(one); });
}

// Writes into the report of a job, or instead of one, that the job failed and why.
void write_failure(const Path& folder, std::optional<sim::Json> report, const std::string& problem) {
    sim::Json json = report ? std::move(*report) : json_without_times(sim::DressReport{});
    json[sim::report_key::kOutcome] = "failed";
    json[sim::report_key::kProblem] = problem;
    sim::write_file_atomically(folder / job_file::kReport, write_json(json));
}

void count(BatchCounts& counts, const JobRecord& record) {
    if (record.has_failed) {
        ++counts.failed;
    } else if (record.exit_code == exit_code_of(sim::Outcome::Dressed)) {
        ++counts.dressed;
    } else if (record.exit_code == exit_code_of(sim::Outcome::DoesNotFit)) {
        ++counts.does_not_fit;
    } else if (record.exit_code == exit_code_of(sim::Outcome::Defect)) {
        ++counts.defects;
    } else {
        ++counts.refused;
    }
}

// Well or not.
bool is_dressed(const JobRecord& record) {
    return !record.has_failed && record.exit_code != exit_code_of(sim::Outcome::Refused);
}

class BatchRun {
 public:
    BatchRun(const std::vector<Job>& jobs, const BatchOptions& options, const BatchWork& work)
        : jobs_(jobs), options_(options), work_(work), pool_(options.limits) {}

    BatchCounts run() {
        plan();
        const Clock::time_point start = Clock::now();
        while (next_ < todo_.size() || pool_.running() > 0) {
            const bool goes_on = !work_.is_stopped();
            if (goes_on) begin_some();
            if (pool_.running() > 0) {
                const std::optional<WorkResult> result = pool_.wait(kPulse);
                if (result) end(*result);
            } else if (!goes_on) {
                break;
            } else if (next_ < todo_.size()) {
                wait_for_a_process();
            }
            counts_.seconds = std::chrono::duration<double>(Clock::now() - start).count();
            work_.progress(counts_);
        }
        return counts_;
    }

 private:
    void plan() {
        for (std::size_t i = options_.shard.index - 1; i < jobs_.size(); i += options_.shard.count) {
            ++counts_.jobs;
            keys_[i] = work_.key(jobs_[i]);
            std::optional<JobResult> earlier;
            if (!options_.does_all_again) earlier = read_result(options_.output, jobs_[i].name, keys_[i]);
            if (earlier && !earlier->record.has_failed) {
                ++counts_.skipped;
                count(counts_, earlier->record);
            } else {
                todo_.push_back(i);
            }
        }
        std::ranges::stable_sort(todo_, {}, [&](std::size_t i) { return body_key(jobs_[i]); });
    }

    void begin_some() {
        while (next_ < todo_.size() && pool_.running() < std::size_t(options_.workers) && begin(todo_[next_])) ++next_;
    }

    // For a single job it would gain nothing.
    void prepare(std::size_t job) {
        const std::string body = body_key(jobs_[job]);
        const bool is_last = next_ + 1 == todo_.size() || body_key(jobs_[todo_[next_ + 1]]) != body;
        if (tried_bodies_.contains(body) && !(is_last && body != prepared_)) {
            work_.prepare(jobs_[job]);
            prepared_ = body;
        }
    }

    // False if the system has no process left for it now.
    bool begin(std::size_t job) {
        try {
            auto folder = std::make_unique<UnfinishedJob>(options_.output, jobs_[job].name);
            const Path path = folder->path();
            prepare(job);
            if (!pool_.start(job, folder->file(job_file::kLog), [&] { return work_.dress(jobs_[job], path); }))
                return false;
            unfinished_[job] = std::move(folder);
            tries_ = 0;
        } catch (const sim::InputError& error) {
            count_unrecorded(error);
        }
        return true;
    }

    // No job runs that could end and give its process free.
    void wait_for_a_process() {
        constexpr int kMostTries = 50;  // 10 s
        if (++tries_ > kMostTries)
            throw sim::InputError("", "", "no process could be started: the system has none left");
        std::this_thread::sleep_for(kPulse);
    }

    void end(const WorkResult& result) {
        const std::unique_ptr<UnfinishedJob> folder = std::move(unfinished_[result.job]);
        unfinished_.erase(result.job);
        try {
            const JobRecord record = finish(*folder, result);
            ++counts_.done;
            count(counts_, record);
            if (is_dressed(record)) tried_bodies_.insert(body_key(jobs_[result.job]));
        } catch (const sim::InputError& error) {
            count_unrecorded(error);
        }
    }

    JobRecord finish(UnfinishedJob& folder, const WorkResult& result) const {
        JobRecord record{.key = keys_.at(result.job),
                         .exit_code = result.code,
                         .has_failed = true,
                         .wall_s = result.wall_s,
                         .cpu_s = result.cpu_s,
                         .peak_memory_mb = result.peak_memory_mb};
        std::optional<sim::Json> report;
        if (result.end == WorkEnd::Exited) report = read_report(folder.path());
        const bool has_outcome = report && is_outcome(*report, result.code);
        record.has_failed = !has_outcome || work_.have_inputs_changed(jobs_[result.job], *report);
        if (record.has_failed) {
            record.exit_code = 2;
            write_failure(folder.path(), std::move(report),
                          has_outcome ? "one of its inputs was changed while the batch ran"
                                      : failure_of(result, options_.limits, folder.file(job_file::kLog)));
        }
        folder.finish(record);
        return record;
    }

    void count_unrecorded(const sim::InputError& error) {
        ++counts_.done;
        ++counts_.failed;
        ++counts_.unrecorded;
        if (counts_.problem.empty()) counts_.problem = error.what();
    }

    const std::vector<Job>& jobs_;
    const BatchOptions& options_;
    const BatchWork& work_;
    BatchCounts counts_;
    std::vector<std::size_t> todo_;
    std::size_t next_ = 0;  // of todo_
    int tries_ = 0;         // in a row to start a process
    std::map<std::size_t, std::string> keys_;
    std::set<std::string> tried_bodies_;  // on which a garment was dressed
    std::string prepared_;                // the body that was prepared last
    std::map<std::size_t, std::unique_ptr<UnfinishedJob>> unfinished_;
    WorkerPool pool_;  // last: its processes end before the folders go that they write
};

}  // namespace

Shard parse_shard(const std::string& text) {
    Shard shard;
    const char* const end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, shard.index);
    const bool has_slash = first.ec == std::errc() && first.ptr != end && *first.ptr == '/';
    const auto second = has_slash ? std::from_chars(first.ptr + 1, end, shard.count) : first;
    constexpr std::size_t kMost = 100'000;
    if (!has_slash || second.ec != std::errc() || second.ptr != end || shard.index < 1 || shard.index > shard.count ||
        shard.count > kMost)
        throw sim::InputError("", "--shard", "'" + text + "' is not I/N, with I from 1 to N");
    return shard;
}

BatchCounts run_batch(const std::vector<Job>& jobs, const BatchOptions& options, const BatchWork& work) {
    std::error_code error;
    std::filesystem::create_directories(options.output / "jobs", error);
    if (error) throw sim::InputError(options.output.string(), "", "cannot be made: " + error.message());
    const FileLock lock(lock_file(options));
    if (lock.is_taken()) throw sim::InputError(options.output.string(), "", "another run is doing these jobs here");
    std::set<std::string> own;
    for (std::size_t i = options.shard.index - 1; i < jobs.size(); i += options.shard.count) own.insert(jobs[i].name);
    delete_strays(options.output, own);
    return BatchRun(jobs, options, work).run();
}

}  // namespace selvedge::batch
