#include "app/piped_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <stdexcept>

extern char** environ;

namespace selvedge {
namespace {

// Writing to a program that has ended shall be an answer, not the end of ours.
class WithoutPipeSignal {
 public:
    WithoutPipeSignal() {
        struct sigaction ignored {};
        ignored.sa_handler = SIG_IGN;
        ::sigaction(SIGPIPE, &ignored, &before_);
    }
    ~WithoutPipeSignal() { ::sigaction(SIGPIPE, &before_, nullptr); }
    WithoutPipeSignal(const WithoutPipeSignal&) = delete;
    WithoutPipeSignal& operator=(const WithoutPipeSignal&) = delete;

 private:
    struct sigaction before_ {};
};

int spawn(pid_t& process, std::vector<std::string> arguments, int input, int complaints) {
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, complaints, STDERR_FILENO);
    std::vector<char*> words;
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    const int error = ::posix_spawnp(&process, words.front(), &files, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    return error;
}

}  // namespace

bool has_program(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
        const std::filesystem::path program = std::filesystem::path(folder.empty() ? "." : folder) / name;
        std::error_code ignored;
        if (std::filesystem::is_regular_file(program, ignored) && ::access(program.c_str(), X_OK) == 0) return true;
    }
    return false;
}

PipedProcess::PipedProcess(const std::vector<std::string>& arguments) : complaints_(std::tmpfile()) {
    std::array<int, 2> ends{};
    if (complaints_ == nullptr || ::pipe2(ends.data(), O_CLOEXEC) != 0) {
        if (complaints_ != nullptr) std::fclose(complaints_);
        throw std::runtime_error("cannot start " + arguments.front() + ": " + std::strerror(errno));
    }
    const int error = spawn(process_, arguments, ends[0], ::fileno(complaints_));
    ::close(ends[0]);
    pipe_ = ends[1];
    if (error == 0) return;
    process_ = -1;
    close_pipe();
    std::fclose(complaints_);
    throw std::runtime_error("cannot start " + arguments.front() + ": " + std::strerror(error));
}

PipedProcess::~PipedProcess() {
    close_pipe();
    if (process_ > 0) {
        ::kill(process_, SIGKILL);
        while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    std::fclose(complaints_);
}

bool PipedProcess::write(std::string_view bytes) {
    const WithoutPipeSignal guard;
    while (!bytes.empty()) {
        const ssize_t written = ::write(pipe_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

bool PipedProcess::finish() {
    close_pipe();
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0) {
        if (errno != EINTR) break;
    }
    process_ = -1;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string PipedProcess::complaint() const {
    std::array<char, 300> text{};
    const ssize_t got = ::pread(::fileno(complaints_), text.data(), text.size() - 1, 0);
    const std::string words(text.data(), got > 0 ? static_cast<std::size_t>(got) : 0);
    return words.substr(0, words.find('\n'));
}

void PipedProcess::close_pipe() {
    if (pipe_ >= 0) ::close(pipe_);
    pipe_ = -1;
}

}  // namespace selvedge
