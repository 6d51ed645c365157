#include "batch/run.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstring>
#include <map>
#include <memory>
#include <utility>

#include "batch/job_folder.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/file_path.h"
#include "sim/core/json.h"
#include "sim/dress/report.h"

namespace selvedge::batch {
namespace {

using Path = std::filesystem::path;
using Clock = std::chrono::steady_clock;

// While it exists, no other process has the lock of the same file, on this machine or, over NFS, on another. The system
// gives it free when the process ends, however that comes about; its children do not have it (POSIX record locks).
class FileLock {
 public:
    explicit FileLock(const Path& path) : fd_(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
        if (fd_ < 0) throw sim::InputError(path.string(), "", std::string("cannot write: ") + std::strerror(errno));
        struct flock whole {};
        whole.l_type = F_WRLCK;
        whole.l_whence = SEEK_SET;
        if (::fcntl(fd_, F_SETLK, &whole) == 0 || (errno != EAGAIN && errno != EACCES)) return;
        ::close(fd_);
        throw sim::InputError(path.parent_path().string(), "", "another run is doing these jobs here");
    }
    ~FileLock() { ::close(fd_); }
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

 private:
    int fd_;
};

// The file stays: to delete it would let two runs lock two files of one name.
Path lock_file(const BatchOptions& options) {
    return options.output /
           (".lock-" + std::to_string(options.shard.index) + "-of-" + std::to_string(options.shard.count));
}

std::string failure_of(const WorkResult& result, const JobLimits& limits) {
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
    return {};
}

// What did not write a report gets one that says why.
void write_missing_report(const Path& folder, const std::string& problem, bool has_failed) {
    sim::DressReport report;
    report.problem = problem;
    sim::Json json = json_without_times(report);
    if (has_failed) json[sim::report_key::kOutcome] = "failed";
    sim::write_file_atomically(folder / job_file::kReport, write_json(json));
}

std::string last_line(const Path& log) {
    constexpr std::size_t kMost = 1 << 20;
    std::string text = sim::read_file(log, kMost);
    while (text.ends_with('\n')) text.pop_back();
    return text.substr(text.rfind('\n') + 1);
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

class BatchRun {
 public:
    BatchRun(const std::vector<Job>& jobs, const BatchOptions& options, const BatchWork& work)
        : jobs_(jobs), options_(options), work_(work), pool_(options.limits) {}

    BatchCounts run() {
        plan();
        const Clock::time_point start = Clock::now();
        std::size_t next = 0;
        constexpr auto kPulse = std::chrono::milliseconds(200);
        while (next < todo_.size() || pool_.running() > 0) {
            const bool goes_on = !work_.is_stopped();
            while (goes_on && next < todo_.size() && pool_.running() < std::size_t(options_.workers))
                begin(todo_[next++]);
            if (pool_.running() == 0) break;
            const std::optional<WorkResult> result = pool_.wait(kPulse);
            if (result) end(*result);
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
            const std::optional<JobRecord> record = read_record(options_.output, jobs_[i].name);
            if (record && record->key == keys_[i] && !record->has_failed && !options_.does_all_again) {
                ++counts_.skipped;
                count(counts_, *record);
            } else {
                todo_.push_back(i);
            }
        }
    }

    void begin(std::size_t job) {
        auto folder = std::make_unique<UnfinishedJob>(options_.output, jobs_[job].name);
        pool_.start(job, folder->file(job_file::kLog),
                    [&, path = folder->path()] { return work_.dress(jobs_[job], path); });
        unfinished_[job] = std::move(folder);
    }

    void end(const WorkResult& result) {
        const std::unique_ptr<UnfinishedJob> folder = std::move(unfinished_[result.job]);
        unfinished_.erase(result.job);
        JobRecord record{.key = keys_[result.job],
                         .exit_code = result.code,
                         .has_failed = result.end != WorkEnd::Exited,
                         .wall_s = result.wall_s,
                         .cpu_s = result.cpu_s,
                         .peak_memory_mb = result.peak_memory_mb};
        if (record.has_failed) {
            record.exit_code = 2;
            write_missing_report(folder->path(), failure_of(result, options_.limits), true);
        } else if (!sim::file_exists(folder->file(job_file::kReport))) {
            write_missing_report(folder->path(), last_line(folder->file(job_file::kLog)), false);
        }
        folder->finish(record);
        ++counts_.done;
        count(counts_, record);
    }

    const std::vector<Job>& jobs_;
    const BatchOptions& options_;
    const BatchWork& work_;
    BatchCounts counts_;
    std::vector<std::size_t> todo_;
    std::map<std::size_t, std::string> keys_;
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
    delete_strays(options.output);
    return BatchRun(jobs, options, work).run();
}

}  // namespace selvedge::batch
