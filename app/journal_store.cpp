#include "app/journal_store.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>

#include "sim/core/error.h"
#include "sim/core/file.h"

namespace selvedge::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".journal";
constexpr const char* kDamaged = ".damaged";  // after that
constexpr std::size_t kLargest = std::size_t{1} << 30;

bool write_all(int file, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(file, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

// Whether another process holds the journal's lock. Does not modify the file.
bool is_held(const fs::path& path) {
    const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
    if (file < 0) return true;
    const bool held = ::flock(file, LOCK_EX | LOCK_NB) != 0;
    ::close(file);
    return held;
}

double age_of(const fs::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return 0;
    return std::max(0.0, std::difftime(std::time(nullptr), status.st_mtime));
}

[[noreturn]] void fail(const fs::path& path, const char* what) {
    throw sim::InputError(path.string(), "", std::string(what) + ": " + std::strerror(errno));
}

}  // namespace

JournalStore::JournalStore(fs::path folder) : folder_(std::move(folder)) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) throw sim::InputError(folder_.string(), "", "cannot be made: " + error.message());
    path_ = folder_ / (std::to_string(::getpid()) + kEnding);
    for (int i = 2; fs::exists(path_); ++i) {
        path_ = folder_ / (std::to_string(::getpid()) + "-" + std::to_string(i) + kEnding);
    }
    syncing_ = std::thread([this] { sync_periodically(); });
}

JournalStore::~JournalStore() {
    {
        const std::lock_guard lock(mutex_);
        is_ending_ = true;
    }
    wake_.notify_all();
    syncing_.join();
    close_file();
}

// Writes a new file, locked from the start, and renames it over the old one: a crash leaves either the old or the new
// journal.
void JournalStore::begin(std::string_view lines) {
    const fs::path fresh = path_.string() + ".new";
    const int file = ::open(fresh.c_str(), O_CREAT | O_TRUNC | O_RDWR | O_APPEND | O_CLOEXEC, 0600);
    if (file < 0) fail(fresh, "cannot be written");
    const bool is_written = ::flock(file, LOCK_EX | LOCK_NB) == 0 && write_all(file, lines) && write_all(file, "\n") &&
                            ::rename(fresh.c_str(), path_.c_str()) == 0;
    if (!is_written) {
        ::close(file);
        fail(fresh, "cannot be written");
    }
    const std::lock_guard lock(mutex_);
    close_file();
    file_ = file;
    is_dirty_ = true;
    wake_.notify_all();
}

void JournalStore::note(std::string_view line) {
    const std::lock_guard lock(mutex_);
    if (file_ < 0) return;
    const std::string whole = std::string(line) + "\n";
    if (!write_all(file_, whole) && problem_.empty()) problem_ = path_.string() + ": " + std::strerror(errno);
    is_dirty_ = true;
}

void JournalStore::end() {
    const std::lock_guard lock(mutex_);
    if (file_ < 0) return;
    ::unlink(path_.c_str());
    close_file();
}

void JournalStore::close_file() {
    if (file_ >= 0) ::close(file_);
    file_ = -1;
}

void JournalStore::sync_periodically() {
    std::unique_lock lock(mutex_);
    while (!is_ending_) {
        wake_.wait_for(lock, std::chrono::seconds(1), [this] { return is_ending_; });
        if (!is_dirty_ || file_ < 0) continue;
        is_dirty_ = false;
        const int file = ::dup(file_);  // a duplicate, so that note() is not blocked while the disk syncs
        lock.unlock();
        ::fdatasync(file);
        ::close(file);
        lock.lock();
    }
}

std::vector<StoredJournal> JournalStore::left() const {
    std::vector<StoredJournal> found;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
        const fs::path& path = entry.path();
        if (path.extension() != kEnding || path == path_ || is_held(path)) continue;
        try {
            found.push_back({.path = path, .text = sim::read_file(path, kLargest), .age_seconds = age_of(path)});
        } catch (const sim::InputError&) {  // removed meanwhile, or not a regular file
        }
    }
    std::sort(found.begin(), found.end(), [](const StoredJournal& a, const StoredJournal& b) {
        return a.age_seconds != b.age_seconds ? a.age_seconds < b.age_seconds : a.path < b.path;
    });
    return found;
}

void JournalStore::discard(const fs::path& path) {
    std::error_code error;
    fs::remove(path, error);
}

fs::path JournalStore::set_aside(const fs::path& path) {
    fs::path target = path.string() + kDamaged;
    for (int i = 2; fs::exists(target); ++i) target = path.string() + "-" + std::to_string(i) + kDamaged;
    if (::rename(path.c_str(), target.c_str()) != 0) fail(path, "cannot be renamed");
    return target;
}

fs::path state_folder() {
    const char* state = std::getenv("XDG_STATE_HOME");
    if (state != nullptr && *state == '/') return fs::path(state) / "selvedge";
    const char* home = std::getenv("HOME");
    if (home != nullptr && *home == '/') return fs::path(home) / ".local/state/selvedge";
    return fs::temp_directory_path() / "selvedge";
}

}  // namespace selvedge::app
