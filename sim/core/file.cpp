#include "sim/core/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstring>

#include "sim/core/atomic_file.h"
#include "sim/core/error.h"

namespace selvedge::sim {
namespace {

class Descriptor {
 public:
    Descriptor(const std::filesystem::path& path, int flags) : fd_(::open(path.c_str(), flags | O_CLOEXEC)) {}
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    bool is_open() const { return fd_ >= 0; }
    int get() const { return fd_; }

 private:
    int fd_;
};

[[noreturn]] void fail_to_read(const std::filesystem::path& path) {
    const std::string reason = std::strerror(errno);
    throw InputError(path.string(), "", "cannot read: " + reason);
}

}  // namespace

std::string read_file(const std::filesystem::path& path, std::size_t max_bytes) {
    Descriptor file(path, O_RDONLY | O_NONBLOCK);
    if (!file.is_open()) fail_to_read(path);
    struct stat status {};
    if (::fstat(file.get(), &status) != 0) fail_to_read(path);
    if (!S_ISREG(status.st_mode)) throw InputError(path.string(), "", "not a regular file");
    if (static_cast<std::size_t>(status.st_size) > max_bytes) {
        throw InputError(
            path.string(), "",
            "file of " + std::to_string(status.st_size) + " bytes is over the limit of " + std::to_string(max_bytes));
    }
    std::string content(static_cast<std::size_t>(status.st_size), '\0');
    std::size_t done = 0;
    while (done < content.size()) {
        const ssize_t got = ::read(file.get(), content.data() + done, content.size() - done);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail_to_read(path);
        if (got == 0) break;
        done += static_cast<std::size_t>(got);
    }
    content.resize(done);
    return content;
}

void write_file_atomically(const std::filesystem::path& path, std::string_view content) {
    AtomicFile file(path);
    file.append(content);
    file.commit();
}

}  // namespace selvedge::sim
