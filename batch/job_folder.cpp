#include "batch/job_folder.h"

#include <fcntl.h>
#include <sys/random.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/file_path.h"
#include "sim/core/json.h"
#include "sim/inspection/report.h"

namespace selvedge::batch {
namespace {

using Path = std::filesystem::path;

constexpr std::string_view kUnfinished = ".unfinished@";  // NAME.unfinished@NUMBER
constexpr std::string_view kOld = ".old@";                // a result that is being replaced
constexpr std::string_view kLock = ".lock";               // in an unfinished folder
constexpr std::size_t kMostRecordBytes = 1 << 20;

// A path that no other process chooses, on whatever machine.
Path beside(const Path& target, std::string_view mark) {
    std::uint64_t number = 0;
    while (::getrandom(&number, sizeof number, 0) != static_cast<ssize_t>(sizeof number)) {
    }
    std::array<char, 17> digits{};
    std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(number));
    return target.string() + std::string(mark) + digits.data();
}

// The name of the job that left a folder with this mark; none of another folder.
std::optional<std::string> job_of_stray(const Path& path, std::string_view mark) {
    const std::string name = path.filename().string();
    const std::size_t at = name.find(mark);
    if (at == std::string::npos) return std::nullopt;
    return name.substr(0, at);
}

bool is_older_than_any_job(const Path& path) {
    constexpr auto kLongest = std::chrono::hours(48);  // twice the largest limit of time
    std::error_code error;
    const auto changed = std::filesystem::last_write_time(path, error);
    return !error && std::filesystem::file_time_type::clock::now() - changed > kLongest;
}

// Puts the new folder in the place of the old one, which is behind it at `path`. If the file system cannot do this at
// once, there is a moment at which the old one has a name that delete_strays() knows, and none is in its place.
std::error_code exchange(const Path& path, const Path& target) {
    if (::renameat2(AT_FDCWD, path.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) == 0) return {};
    const Path old = beside(target, kOld);
    std::error_code error, ignored;
    std::filesystem::rename(target, old, error);
    if (error) return error;
    std::filesystem::rename(path, target, error);
    std::filesystem::rename(old, error ? target : path, ignored);
    return error;
}

}  // namespace

Path job_folder(const Path& output, const std::string& name) {
    return output / "jobs" / name;
}

std::optional<JobRecord> read_record(const Path& output, const std::string& name) {
    const Path file = job_folder(output, name) / job_file::kRecord;
    if (!sim::file_exists(file)) return std::nullopt;
    try {
        const sim::Json json = sim::parse_json(sim::read_file(file, kMostRecordBytes), file.string());
        const sim::JsonView view(json, file.string());
        JobRecord record;
        record.key = view.at("key").string();
        record.exit_code = view.at("exit_code").integer();
        record.has_failed = view.at("has_failed").boolean();
        record.wall_s = view.at("wall_s").number();
        record.cpu_s = view.at("cpu_s").number();
        record.peak_memory_mb = view.at("peak_memory_mb").number();
        return record;
    } catch (const sim::InputError&) {
        return std::nullopt;
    }
}

std::optional<JobResult> read_result(const Path& output, const std::string& name, const std::string& key) {
    std::optional<JobRecord> record = read_record(output, name);
    if (!record || record->key != key) return std::nullopt;
    std::optional<sim::Json> report = read_report(job_folder(output, name));
    if (!report) return std::nullopt;
    return JobResult{.record = std::move(*record), .report = std::move(*report)};
}

std::optional<sim::Json> read_report(const Path& folder) {
    constexpr std::size_t kMostReportBytes = std::size_t(64) << 20;
    const Path file = folder / job_file::kReport;
    if (!sim::file_exists(file)) return std::nullopt;
    try {
        sim::Json report = sim::parse_json(sim::read_file(file, kMostReportBytes), file.string());
        if (outcome_in(report).empty()) return std::nullopt;
        return report;
    } catch (const sim::InputError&) {
        return std::nullopt;
    }
}

std::string outcome_in(const sim::Json& report) {
    const sim::Json* outcome = report.is_object() ? report.find(sim::report_key::kOutcome) : nullptr;
    return outcome == nullptr || !outcome->is_string() ? std::string() : outcome->string();
}

UnfinishedJob::UnfinishedJob(const Path& output, const std::string& name)
    : target_(job_folder(output, name)), path_(beside(target_, kUnfinished)) {
    std::error_code error;
    std::filesystem::create_directories(path_, error);
    if (error) throw sim::InputError(path_.string(), "", "cannot be made: " + error.message());
    try {
        lock_.emplace(file(kLock));
    } catch (const sim::InputError&) {  // its name alone protects it
    }
}

UnfinishedJob::~UnfinishedJob() {
    std::error_code ignored;
    lock_.reset();  // over NFS, a file that is open cannot go
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

void UnfinishedJob::finish(const JobRecord& record) {
    sim::Json json = sim::Json::object();
    json["key"] = record.key;
    json["exit_code"] = record.exit_code;
    json["has_failed"] = record.has_failed;
    json["wall_s"] = record.wall_s;
    json["cpu_s"] = record.cpu_s;
    json["peak_memory_mb"] = record.peak_memory_mb;
    sim::write_file_atomically(file(job_file::kRecord), write_json(json));
    std::error_code error;
    std::filesystem::rename(path_, target_, error);
    if (error == std::errc::directory_not_empty || error == std::errc::file_exists) error = exchange(path_, target_);
    if (error) throw sim::InputError(target_.string(), "", "cannot be written: " + error.message());
    lock_.reset();
    std::filesystem::remove(target_ / kLock, error);
    std::filesystem::remove_all(path_, error);  // the older one, if there was one
    path_.clear();
}

void delete_strays(const Path& output, const std::set<std::string>& own) {
    std::error_code error;
    for (const Path& path : sim::entries_of(output / "jobs", error)) {
        std::error_code ignored;
        if (const std::optional<std::string> old = job_of_stray(path, kOld)) {
            if (!own.contains(*old)) continue;
            const Path target = job_folder(output, *old);
            if (sim::file_exists(target)) {
                std::filesystem::remove_all(path, ignored);
            } else {
                std::filesystem::rename(path, target, ignored);
            }
        } else if (const std::optional<std::string> unfinished = job_of_stray(path, kUnfinished)) {
            const bool is_stray = own.contains(*unfinished) || is_older_than_any_job(path);
            if (is_stray && !is_locked_by_another(path / kLock)) std::filesystem::remove_all(path, ignored);
        }
    }
}

}  // namespace selvedge::batch
