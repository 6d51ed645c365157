#include "sim/core/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <utility>

#include "sim/core/assert.h"
#include "sim/core/error.h"

namespace selvedge::sim {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path) {
    const std::string reason = std::strerror(errno);
    throw InputError(path.string(), "", "cannot write: " + reason);
}

// The path with symbolic links resolved, so that writing replaces the target of a link and not the link itself.
std::filesystem::path behind_links(const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::path target = std::filesystem::canonical(path, error);
    return error ? path : target;
}

std::filesystem::path folder_of(const std::filesystem::path& path) {
    return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

}  // namespace

AtomicFile::AtomicFile(const std::filesystem::path& path) : path_(path), target_(behind_links(path)) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(target_, error);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throw InputError(path_.string(), "", "cannot write: it is no regular file");
    temporary_ = folder_of(target_) / ("." + target_.filename().string() + "." + std::to_string(::getpid()) + ".tmp");
    fd_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (fd_ < 0) fail(path_);
}

AtomicFile::~AtomicFile() {
    if (fd_ >= 0) ::close(fd_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::write_at(std::uint64_t offset, std::string_view content) {
    SELVEDGE_ASSERT(fd_ >= 0);
    while (!content.empty()) {
        const ssize_t written = ::pwrite(fd_, content.data(), content.size(), static_cast<off_t>(offset));
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
    SELVEDGE_ASSERT(fd_ >= 0);
    if (::fsync(fd_) != 0) fail(path_);
    const int fd = std::exchange(fd_, -1);
    if (::close(fd) != 0) fail(path_);
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(path_);
    temporary_.clear();
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
