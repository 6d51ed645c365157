#include "batch/file_lock.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "sim/core/error.h"

namespace selvedge::batch {
namespace {

struct flock whole_file() {
    struct flock lock {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    return lock;
}

}  // namespace

FileLock::FileLock(const std::filesystem::path& path)
    : fd_(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)), is_taken_(false) {
    if (fd_ < 0) throw sim::InputError(path.string(), "", std::string("cannot write: ") + std::strerror(errno));
    struct flock whole = whole_file();
    is_taken_ = ::fcntl(fd_, F_SETLK, &whole) != 0 && (errno == EAGAIN || errno == EACCES);
}

FileLock::~FileLock() {
    ::close(fd_);
}

bool is_locked_by_another(const std::filesystem::path& path) {
    const int fd = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
    if (fd < 0) return false;
    struct flock whole = whole_file();
    const bool is_locked = ::fcntl(fd, F_GETLK, &whole) == 0 && whole.l_type != F_UNLCK;
    ::close(fd);
    return is_locked;
}

}  // namespace selvedge::batch
