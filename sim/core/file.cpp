#include "sim/core/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstring>

#include "sim/core/error.h"

namespace selvedge::sim {
namespace {

class Descriptor {
 public:
    Descriptor(const std::filesystem::path& path, int flags, mode_t mode = 0)
        : fd_(::open(path.c_str(), flags | O_CLOEXEC, mode)) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    bool is_open() const { return fd_ >= 0; }
    int get() const { return fd_; }
    bool close() {
        const bool closed = fd_ < 0 || ::close(fd_) == 0;
        fd_ = -1;
        return closed;
    }

 private:
    int fd_;
};

[[noreturn]] void fail(const std::filesystem::path& path, const char* verb) {
    const std::string reason = std::strerror(errno);
    throw InputError(path.string(), "", std::string("cannot ") + verb + ": " + reason);
}

void write_all(int fd, std::string_view content, const std::filesystem::path& path) {
    while (!content.empty()) {
        const ssize_t written = ::write(fd, content.data(), content.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(path, "write");
        content.remove_prefix(static_cast<std::size_t>(written));
    }
}

// The path with symbolic links resolved, so that writing replaces the target of a link and not the link itself.
std::filesystem::path behind_links(const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::path target = std::filesystem::canonical(path, error);
    return error ? path : target;
}

}  // namespace

std::string read_file(const std::filesystem::path& path, std::size_t max_bytes) {
    Descriptor file(path, O_RDONLY | O_NONBLOCK);
    if (!file.is_open()) fail(path, "read");
    struct stat status {};
    if (::fstat(file.get(), &status) != 0) fail(path, "read");
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
        if (got < 0) fail(path, "read");
        if (got == 0) break;
        done += static_cast<std::size_t>(got);
    }
    content.resize(done);
    return content;
}

void write_file_atomically(const std::filesystem::path& path, std::string_view content) {
    const std::filesystem::path target = behind_links(path);
    const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : std::filesystem::path(".");
    const std::filesystem::path temporary =
        folder / ("." + target.filename().string() + "." + std::to_string(::getpid()) + ".tmp");
    try {
        Descriptor file(temporary, O_WRONLY | O_CREAT | O_TRUNC, 0644);
        if (!file.is_open()) fail(target, "write");
        write_all(file.get(), content, target);
        if (::fsync(file.get()) != 0 || !file.close()) fail(target, "write");
        if (::rename(temporary.c_str(), target.c_str()) != 0) fail(target, "write");
    } catch (...) {
        ::unlink(temporary.c_str());
        throw;
    }
    const Descriptor parent(folder, O_RDONLY | O_DIRECTORY);
    if (parent.is_open()) ::fsync(parent.get());
}

}  // namespace selvedge::sim
