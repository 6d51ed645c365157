#include "sim/core/guarded_child.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <new>
#include <system_error>
#include <utility>

#include "sim/core/file_path.h"
#include "sim/core/passing_error.h"
#include "sim/core/process_memory.h"
#include "sim/core/stopwatch.h"
#include "sim/core/system_call_filter.h"

namespace selvedge::sim {
namespace {

void limit(decltype(RLIMIT_CPU) resource, rlim_t most) {
    const rlimit values{most, most};
    ::setrlimit(resource, &values);
}

// From `first` to `last`. A kernel that lacks the call (before 5.9) lists what is open in /proc.
void close_descriptors(int first, int last) {
    if (first > last || ::close_range(unsigned(first), unsigned(last), 0) == 0) return;
    std::error_code error;
    for (const std::filesystem::path& entry : entries_of("/proc/self/fd", error)) {
        const int descriptor = std::atoi(entry.filename().c_str());
        if (descriptor >= first && descriptor <= last) ::close(descriptor);
    }
}

// Of what the program has open, such as a document's journal or a connection, only the pipe and the standard streams
// stay.
void close_all_but(int pipe_end) {
    close_descriptors(STDERR_FILENO + 1, pipe_end - 1);
    close_descriptors(std::max(pipe_end, STDERR_FILENO) + 1, std::numeric_limits<int>::max());
}

void confine(const ChildLimits& limits, int pipe_end) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_CPU, rlim_t(limits.processor_seconds));
    limit_more_memory(limits.memory_bytes);
    const int nowhere = ::open("/dev/null", O_RDWR);
    for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, standard);
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGTERM, SIGINT, SIGPIPE, SIGSYS})
        ::signal(signal, SIG_DFL);
    close_all_but(pipe_end);
    forbid_all_but_reading(pipe_end);
}

// Exits without running the parent's destructors and exit handlers.
[[noreturn]] void run_and_exit(const std::function<std::string()>& work, const ChildLimits& limits, int pipe_end) {
    constexpr int kFailed = 1;
    try {
        confine(limits, pipe_end);
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
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGSYS) return {ChildEnd::Forbidden, {}};
    // SIGKILL comes from the hard CPU limit: run_in_child() itself has not killed this child.
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) return {ChildEnd::TimedOut, {}};
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return {ChildEnd::Crashed, {}};
    return result;
}

std::string answer_of_child(const std::function<std::string()>& work, const std::string& file,
                            const ChildLimits& limits) {
    ChildResult result = run_in_child(work, limits);
    switch (result.end) {
        case ChildEnd::NotStarted:
            throw PassingError(file, "", "no process could be started to read it");
        case ChildEnd::Crashed:
            throw InputError(file, "", "the file crashes its reader");
        case ChildEnd::Forbidden:
            throw InputError(file, "", "the file makes its reader do what is forbidden to it");
        case ChildEnd::TimedOut:
            throw PassingError(file, "", "the file takes its reader too long");
        case ChildEnd::TooMuch:
            throw InputError(file, "", "the file holds too much");
        case ChildEnd::Done:
            break;
    }
    return std::move(result.answer);
}

void check_memory_of_child(const std::string& failure, const std::string& file) {
    if (failure == std::bad_alloc().what())
        throw PassingError(file, "", "its reader needs more memory than it may have");
}

}  // namespace selvedge::sim
