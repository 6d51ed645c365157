#include "batch/job_folder.h"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <string>
#include <system_error>

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/file_path.h"
#include "sim/core/json.h"

namespace selvedge::batch {
namespace {

using Path = std::filesystem::path;

constexpr std::string_view kUnfinished = ".unfinished@";  // NAME.unfinished@HOST@PID
constexpr std::string_view kOld = ".old@";
constexpr std::size_t kMostBytes = 1 << 20;

std::string host_name() {
    std::array<char, 256> name{};
    if (::gethostname(name.data(), name.size() - 1) != 0) return "host";
    std::string text(name.data());
    for (char& c : text) {
        if (c == '/' || c == '@') c = '-';
    }
    return text;
}

Path beside(const Path& target, std::string_view mark) {
    return target.string() + std::string(mark) + host_name() + "@" + std::to_string(::getpid());
}

// Whether it was left by a process of this machine that has ended, or is too old to be in use.
bool is_stray(const Path& path, const std::string& host) {
    const std::string name = path.filename().string();
    const std::size_t mark = std::min(name.find(kUnfinished), name.find(kOld));
    if (mark == std::string::npos) return false;
    const std::size_t at = name.find('@', mark), second = name.find('@', at + 1);
    if (at == std::string::npos || second == std::string::npos) return false;
    std::error_code error;
    const auto changed = std::filesystem::last_write_time(path, error);
    const bool is_old = !error && std::filesystem::file_time_type::clock::now() - changed > std::chrono::hours(24);
    if (is_old) return true;
    if (name.substr(at + 1, second - at - 1) != host) return false;
    int pid = 0;
    std::from_chars(name.data() + second + 1, name.data() + name.size(), pid);
    return pid > 0 && ::kill(pid, 0) != 0 && errno == ESRCH;
}

}  // namespace

Path job_folder(const Path& output, const std::string& name) {
    return output / "jobs" / name;
}

std::optional<JobRecord> read_record(const Path& output, const std::string& name) {
    const Path file = job_folder(output, name) / job_file::kRecord;
    if (!sim::file_exists(file)) return std::nullopt;
    try {
        const sim::Json json = sim::parse_json(sim::read_file(file, kMostBytes), file.string());
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

UnfinishedJob::UnfinishedJob(const Path& output, const std::string& name)
    : target_(job_folder(output, name)), path_(beside(target_, kUnfinished)) {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
    std::filesystem::create_directories(path_, error);
    if (error) throw sim::InputError(path_.string(), "", "cannot be made: " + error.message());
}

UnfinishedJob::~UnfinishedJob() {
    std::error_code ignored;
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
    const Path old = beside(target_, kOld);
    std::error_code error;
    std::filesystem::remove_all(old, error);
    std::filesystem::rename(target_, old, error);
    if (error && error != std::errc::no_such_file_or_directory)
        throw sim::InputError(target_.string(), "", "cannot be replaced: " + error.message());
    std::filesystem::rename(path_, target_, error);
    if (error) throw sim::InputError(target_.string(), "", "cannot be written: " + error.message());
    path_.clear();
    std::filesystem::remove_all(old, error);
}

void delete_strays(const Path& output) {
    const std::string host = host_name();
    std::error_code error;
    for (const Path& path : sim::entries_of(output / "jobs", error)) {
        std::error_code ignored;
        if (is_stray(path, host)) std::filesystem::remove_all(path, ignored);
    }
}

}  // namespace selvedge::batch
