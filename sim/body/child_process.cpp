#include "sim/body/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>

namespace selvedge::sim {
namespace {

using Clock = std::chrono::steady_clock;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kLimitMemory = false;  // its shadow memory reserves terabytes of address space
#else
constexpr bool kLimitMemory = true;
#endif

void limit(decltype(RLIMIT_CPU) resource, rlim_t most) {
    const rlimit values{most, most};
    ::setrlimit(resource, &values);
}

// Address space in use, bytes. The limit is relative to it, because threads and drivers reserve much that they never
// use.
std::size_t address_space_in_use() {
    std::FILE* file = std::fopen("/proc/self/statm", "r");
    unsigned long pages = 0;
    if (file) {
        if (std::fscanf(file, "%lu", &pages) != 1) pages = 0;
        std::fclose(file);
    }
    return std::size_t(pages) * std::size_t(::sysconf(_SC_PAGESIZE));
}

void confine(const ChildLimits& limits) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_CPU, rlim_t(limits.processor_seconds));
    if (kLimitMemory) limit(RLIMIT_AS, address_space_in_use() + limits.memory_bytes);
    const int nowhere = ::open("/dev/null", O_RDWR);
    for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, standard);
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGTERM, SIGINT, SIGPIPE})
        ::signal(signal, SIG_DFL);
}

// Exits without running the parent's destructors and exit handlers.
[[noreturn]] void run_and_exit(const std::function<std::string()>& work, const ChildLimits& limits, int pipe_end) {
    constexpr int kFailed = 1;
    try {
        confine(limits);
        const std::string answer = work();
        for (std::size_t done = 0; done < answer.size();) {
            const ssize_t written = ::write(pipe_end, answer.data() + done, answer.size() - done);
            if (written < 0 && errno == EINTR) continue;
            if (written <= 0) ::_exit(kFailed);
            done += std::size_t(written);
        }
        ::_exit(0);
    } catch (...) {
        ::_exit(kFailed);
    }
}

// Reads until the child closes its end of the pipe. Done: it did so before the deadline and within answer_bytes.
ChildResult collect(int pipe_end, const ChildLimits& limits) {
    const Clock::time_point deadline = Clock::now() + std::chrono::seconds(limits.wall_seconds);
    ChildResult result;
    std::array<char, 1 << 16> part{};
    while (true) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
        if (left <= 0) return {ChildEnd::TimedOut, {}};
        pollfd waiting{pipe_end, POLLIN, 0};
        const int ready = ::poll(&waiting, 1, int(std::min<long>(left, 60'000)));
        if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
        const ssize_t got = ready < 0 ? -1 : ::read(pipe_end, part.data(), part.size());
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return {ChildEnd::Crashed, {}};
        if (got == 0) return result;
        if (result.answer.size() + std::size_t(got) > limits.answer_bytes) return {ChildEnd::TooMuch, {}};
        result.answer.append(part.data(), std::size_t(got));
    }
}

// The child's exit status as waitpid() gives it.
int reap(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return -1;
    return status;
}

}  // namespace

ChildResult run_in_child(const std::function<std::string()>& work, const ChildLimits& limits) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return {ChildEnd::NotStarted, {}};
    const pid_t child = ::fork();
    if (child < 0) {
        for (const int end : ends) ::close(end);
        return {ChildEnd::NotStarted, {}};
    }
    if (child == 0) {
        ::close(ends[0]);
        run_and_exit(work, limits, ends[1]);
    }
    ::close(ends[1]);
    ChildResult result = collect(ends[0], limits);
    ::close(ends[0]);
    if (result.end != ChildEnd::Done) ::kill(child, SIGKILL);
    const int status = reap(child);
    if (result.end != ChildEnd::Done) return result;
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) return {ChildEnd::TimedOut, {}};
    // SIGKILL comes from the hard CPU limit: run_in_child() itself has not killed this child.
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) return {ChildEnd::TimedOut, {}};
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return {ChildEnd::Crashed, {}};
    return result;
}

}  // namespace selvedge::sim
