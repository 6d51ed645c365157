#include "sim/core/atomic_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <utility>

#include "sim/core/assert.h"
#include "sim/core/error.h"
#include "sim/core/file_path.h"

namespace selvedge::sim {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path) {
    const std::string reason = std::strerror(errno);
    throw InputError(path.string(), "", "cannot write: " + reason);
}

constexpr std::string_view kPrefix = ".selvedge-", kSuffix = ".tmp";
constexpr std::size_t kDigits = 16;

std::string random_name() {
    std::uint64_t number = 0;
    while (::getrandom(&number, sizeof number, 0) != static_cast<ssize_t>(sizeof number)) {
    }
    std::array<char, kDigits + 1> digits{};
    std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(number));
    return std::string(kPrefix) + digits.data() + std::string(kSuffix);
}

// Whether it is one of this user's, and no program that lives holds its lock. The age spares one that was made just now
// and is not locked yet.
bool is_left_behind(const std::filesystem::path& path) {
    constexpr double kLeastAge = 60;  // s
    constexpr int kFlags = O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
    int fd = ::open(path.c_str(), O_RDWR | kFlags);            // NFS locks only what is open for writing
    if (fd < 0) fd = ::open(path.c_str(), O_RDONLY | kFlags);  // it replaces a file that may only be read
    if (fd < 0) return false;
    struct stat status {};
    const bool is_old_and_ours = ::fstat(fd, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == ::geteuid() &&
                                 std::difftime(std::time(nullptr), status.st_mtime) >= kLeastAge;
    const bool is_free = is_old_and_ours && ::flock(fd, LOCK_EX | LOCK_NB) == 0;
    ::close(fd);
    return is_free;
}

// Looks at no more than a number of entries, so that many files in one folder stay fast to write.
void remove_left_behind(const std::filesystem::path& folder) {
    constexpr int kMostEntries = 10'000;
    std::error_code error;
    std::filesystem::directory_iterator entry(folder, error);
    for (int i = 0; i < kMostEntries && !error && entry != std::filesystem::directory_iterator(); ++i) {
        const std::filesystem::path path = entry->path();
        if (is_temporary_name(path.filename().native()) && is_left_behind(path)) ::unlink(path.c_str());
        entry.increment(error);
    }
}

// Whether a file without a name can be given one.
bool can_link_descriptors() {
    return ::access("/proc/self/fd", X_OK) == 0;
}

}  // namespace

bool is_temporary_name(std::string_view name) {
    if (name.size() != kPrefix.size() + kDigits + kSuffix.size()) return false;
    if (!name.starts_with(kPrefix) || !name.ends_with(kSuffix)) return false;
    return name.substr(kPrefix.size(), kDigits).find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

AtomicFile::AtomicFile(const std::filesystem::path& path, TemporaryName name)
    : path_(path), target_(behind_links(path)) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(target_, error);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throw InputError(path_.string(), "", "cannot write: it is no regular file");
    if (std::filesystem::is_symlink(std::filesystem::symlink_status(target_, error))) {
        errno = ELOOP;  // rename() would replace the link itself
        fail(path_);
    }
    remove_left_behind(folder_of(target_));
    open_temporary(name);
    take_rights_of_old();
}

void AtomicFile::open_temporary(TemporaryName name) {
    constexpr mode_t kMode = 0666;  // less the umask
    if (name == TemporaryName::None && can_link_descriptors())
        temporary_.fd = ::open(folder_of(target_).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, kMode);
    if (temporary_.fd < 0) {
        temporary_.path = folder_of(target_) / random_name();
        temporary_.fd = ::open(temporary_.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kMode);
        if (temporary_.fd < 0) temporary_.path.clear();
    }
    if (temporary_.fd < 0) fail(path_);
    ::flock(temporary_.fd, LOCK_EX | LOCK_NB);
}

void AtomicFile::take_rights_of_old() {
    struct stat old {};
    struct stat own {};
    if (::stat(target_.c_str(), &old) != 0 || ::fstat(temporary_.fd, &own) != 0) return;
    mode_t mode = old.st_mode & 0777;
    if (old.st_uid != own.st_uid || old.st_gid != own.st_gid) {
        const bool is_kept = ::fchown(temporary_.fd, old.st_uid, old.st_gid) == 0;
        constexpr auto kSameUser = static_cast<uid_t>(-1);
        if (!is_kept && ::fchown(temporary_.fd, kSameUser, old.st_gid) != 0) mode &= ~mode_t{0070};
    }
    if (::fchmod(temporary_.fd, mode) != 0) fail(path_);
}

AtomicFile::Temporary::~Temporary() {
    if (fd >= 0) ::close(fd);
    if (!path.empty()) ::unlink(path.c_str());
}

// A file cannot replace another one without a name.
void AtomicFile::give_name() {
    const std::string descriptor = "/proc/self/fd/" + std::to_string(temporary_.fd);
    const std::filesystem::path name = folder_of(target_) / random_name();
    if (::linkat(AT_FDCWD, descriptor.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) != 0) fail(path_);
    temporary_.path = name;
}

void AtomicFile::write_at(std::uint64_t offset, std::string_view content) {
    SELVEDGE_ASSERT(temporary_.fd >= 0);
    while (!content.empty()) {
        const ssize_t written = ::pwrite(temporary_.fd, content.data(), content.size(), static_cast<off_t>(offset));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(path_);
        content.remove_prefix(static_cast<std::size_t>(written));
        offset += static_cast<std::uint64_t>(written);
    }
}

void AtomicFile::append(std::string_view content) {
    write_at(size_, content);
    size_ += content.size();
}

void AtomicFile::overwrite(std::uint64_t offset, std::string_view content) {
    SELVEDGE_ASSERT(offset + content.size() <= size_);
    write_at(offset, content);
}

void AtomicFile::commit() {
    SELVEDGE_ASSERT(temporary_.fd >= 0);
    if (::fsync(temporary_.fd) != 0) fail(path_);
    if (temporary_.path.empty()) give_name();
    if (::rename(temporary_.path.c_str(), target_.c_str()) != 0) fail(path_);
    temporary_.path.clear();
    const int fd = std::exchange(temporary_.fd, -1);
    if (::close(fd) != 0) fail(path_);
    const int folder = ::open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return;
    ::fsync(folder);
    ::close(folder);
}

void require_free_space(const std::filesystem::path& path, std::uint64_t bytes) {
    std::error_code error;
    const std::filesystem::space_info space = std::filesystem::space(folder_of(behind_links(path)), error);
    if (error || space.available >= bytes) return;  // a folder that cannot be written fails when it is written
    throw InputError(path.string(), "",
                     "needs " + bytes_text(bytes) + ", and " + bytes_text(space.available) + " are free on the disk");
}

std::string bytes_text(std::uint64_t bytes) {
    constexpr std::array kUnits{"bytes", "kB", "MB", "GB", "TB", "PB", "EB"};
    auto size = static_cast<double>(bytes);
    std::size_t unit = 0;
    for (; size >= 999.5 && unit + 1 < kUnits.size(); ++unit) size /= 1000;
    const auto tenths = std::lround(10 * size);
    const std::string number = unit > 0 && tenths < 100
                                   ? std::to_string(tenths / 10) + '.' + std::to_string(tenths % 10)
                                   : std::to_string(std::lround(size));
    return number + ' ' + kUnits[unit];
}

}  // namespace selvedge::sim
