#include "app/journal_store.h"

#include <fcntl.h>
#include <pwd.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/file_path.h"

namespace selvedge::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".journal";
constexpr const char* kFresh = ".new";        // after that, until it is complete
constexpr const char* kDamaged = ".damaged";  // after that
constexpr std::size_t kLargest = std::size_t{1} << 30;

// Removes what was written from the front of the text. Returns whether that was all; if not, errno says why.
bool write_front(int file, std::string& text) {
    std::size_t done = 0;
    while (done < text.size()) {
        const ssize_t written = ::write(file, text.data() + done, text.size() - done);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) break;
        done += static_cast<std::size_t>(written);
    }
    text.erase(0, done);
    return text.empty();
}

// The folder is the user's alone if it is made here.
void make_folder(const fs::path& folder) {
    std::error_code error;
    const bool is_new = fs::create_directories(folder, error);
    if (error) throw sim::InputError(folder.string(), "", "cannot be made: " + error.message());
    if (is_new) fs::permissions(folder, fs::perms::owner_all, error);
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

// A journal that a killed editor had not begun: the one before it is there too, or there was none.
bool is_half_begun(const fs::path& path) {
    constexpr double kLeastAge = 60;  // s: it may be locked in a moment
    return path.string().ends_with(std::string(kEnding) + kFresh) && sim::is_file(path) && age_of(path) >= kLeastAge &&
           !is_held(path);
}

[[noreturn]] void fail(const fs::path& path, const char* what) {
    throw sim::InputError(path.string(), "", std::string(what) + ": " + std::strerror(errno));
}

}  // namespace

JournalStore::JournalStore(fs::path folder) : folder_(std::move(folder)) {
    make_folder(folder_);
    path_ = folder_ / (std::to_string(::getpid()) + kEnding);
    for (int i = 2; sim::file_exists(path_); ++i) {
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
    const fs::path fresh = path_.string() + kFresh;
    ::unlink(fresh.c_str());  // of a killed editor with the same number
    const int file = ::open(fresh.c_str(), O_CREAT | O_EXCL | O_NOFOLLOW | O_RDWR | O_APPEND | O_CLOEXEC, 0600);
    if (file < 0) fail(fresh, "cannot be written");
    std::string text = std::string(lines) + "\n";
    const bool is_written =
        ::flock(file, LOCK_EX | LOCK_NB) == 0 && write_front(file, text) && ::rename(fresh.c_str(), path_.c_str()) == 0;
    if (!is_written) {
        const int problem = errno;
        ::close(file);
        ::unlink(fresh.c_str());
        errno = problem;
        fail(fresh, "cannot be written");
    }
    const std::lock_guard lock(mutex_);
    close_file();
    file_ = file;
    pending_.clear();
    write_problem_.clear();
    sync_problem_.clear();
    is_dirty_ = true;
    wake_.notify_all();
}

void JournalStore::note(std::string_view line) {
    const std::lock_guard lock(mutex_);
    if (file_ < 0) return;
    pending_ += line;
    pending_ += '\n';
    write_pending();
}

void JournalStore::write_pending() {
    const bool is_written = write_front(file_, pending_);
    write_problem_ = is_written ? "" : path_.string() + ": " + std::strerror(errno);
    is_dirty_ = true;
}

std::string JournalStore::problem() const {
    const std::lock_guard lock(mutex_);
    return write_problem_.empty() ? sync_problem_ : write_problem_;
}

void JournalStore::end() {
    const std::lock_guard lock(mutex_);
    if (file_ < 0) return;
    ::unlink(path_.c_str());
    close_file();
    pending_.clear();
    write_problem_.clear();
    sync_problem_.clear();
}

void JournalStore::close_file() {
    if (file_ >= 0) ::close(file_);
    file_ = -1;
}

void JournalStore::sync_periodically() {
    std::unique_lock lock(mutex_);
    while (!is_ending_) {
        wake_.wait_for(lock, std::chrono::seconds(1), [this] { return is_ending_; });
        if (file_ >= 0 && !pending_.empty()) write_pending();
        if (!is_dirty_ || file_ < 0) continue;
        is_dirty_ = false;
        const int file = ::dup(file_);  // a duplicate, so that note() is not blocked while the disk syncs
        lock.unlock();
        const bool is_synced = ::fdatasync(file) == 0;
        const int problem = errno;
        ::close(file);
        lock.lock();
        if (!is_synced) sync_problem_ = path_.string() + ": " + std::strerror(problem);
    }
}

std::vector<StoredJournal> JournalStore::left() const {
    std::vector<StoredJournal> found;
    std::error_code error;
    for (const fs::path& path : sim::entries_of(folder_, error)) {
        if (is_half_begun(path)) ::unlink(path.c_str());
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
    for (int i = 2; sim::file_exists(target); ++i) target = path.string() + "-" + std::to_string(i) + kDamaged;
    if (::rename(path.c_str(), target.c_str()) != 0) fail(path, "cannot be renamed");
    return target;
}

namespace {

std::optional<fs::path> home_of_user() {
    const char* home = std::getenv("HOME");
    if (home != nullptr && *home == '/') return home;
    std::vector<char> text(std::size_t{1} << 16);
    struct passwd entry {};
    struct passwd* found = nullptr;
    if (::getpwuid_r(::geteuid(), &entry, text.data(), text.size(), &found) != 0 || found == nullptr) return {};
    if (entry.pw_dir == nullptr || *entry.pw_dir != '/') return {};
    return entry.pw_dir;
}

}  // namespace

std::optional<fs::path> state_folder() {
    const char* state = std::getenv("XDG_STATE_HOME");
    if (state != nullptr && *state == '/') return fs::path(state) / "selvedge";
    const std::optional<fs::path> home = home_of_user();
    if (!home) return {};
    return *home / ".local/state/selvedge";
}

}  // namespace selvedge::app
