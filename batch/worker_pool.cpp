#include "batch/worker_pool.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <string>

#include "sim/core/error.h"
#include "sim/core/process_memory.h"

namespace selvedge::batch {
namespace {

constexpr int kOutOfMemoryCode = 125;  // of a child whose memory was refused

// A descriptor that can be read from when the process has ended. The C library of Debian 12 declares pidfd_open() for C
// only.
int open_handle(pid_t pid) {
    return static_cast<int>(::syscall(SYS_pidfd_open, pid, 0));
}

double seconds_of(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

void redirect_output(const std::filesystem::path& log) {
    const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    const int output = file >= 0 ? file : ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    const int input = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (input >= 0) ::dup2(input, STDIN_FILENO);
    if (output < 0) return;
    ::dup2(output, STDOUT_FILENO);
    ::dup2(output, STDERR_FILENO);
}

int guarded(const std::function<int()>& work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        std::fflush(stdout);  // the message is the last line of the log
        std::fprintf(stderr, "selvedge: out of memory\n");
        return kOutOfMemoryCode;
    } catch (const std::exception& error) {
        std::fflush(stdout);
        std::fprintf(stderr, "selvedge: %s\n", error.what());
        return 2;
    }
}

[[noreturn]] void run_child(pid_t parent, const std::filesystem::path& log, const JobLimits& limits,
                            const std::function<int()>& work) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(2);  // it had ended before
    ::setpgid(0, 0);                        // Ctrl+C at the terminal is for the parent, which lets jobs end
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::signal(signal, SIG_DFL);
    redirect_output(log);
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
    if (limits.memory_bytes > 0) sim::limit_more_memory(limits.memory_bytes);
    const int code = guarded(work);
    std::fflush(nullptr);
    ::_exit(code);
}

}  // namespace

WorkerPool::~WorkerPool() {
    for (const Child& child : children_) {
        ::kill(-child.pid, SIGKILL);
        ::kill(child.pid, SIGKILL);
        while (::waitpid(child.pid, nullptr, 0) < 0 && errno == EINTR) {
        }
        ::close(child.handle);
    }
}

bool WorkerPool::start(std::size_t job, const std::filesystem::path& log, const std::function<int()>& work) {
    std::fflush(nullptr);  // or the child would print it once more
    const pid_t parent = ::getpid();
    const pid_t pid = ::fork();
    if (pid < 0 && (errno == EAGAIN || errno == ENOMEM)) return false;
    if (pid < 0) throw sim::InputError("", "", std::string("no process could be started: ") + std::strerror(errno));
    if (pid == 0) run_child(parent, log, limits_, work);
    ::setpgid(pid, pid);  // whoever of the two comes first
    children_.push_back({.job = job, .pid = pid, .handle = open_handle(pid), .start = Clock::now()});
    return true;
}

void WorkerPool::kill_late() {
    for (Child& child : children_) {
        const double seconds = std::chrono::duration<double>(Clock::now() - child.start).count();
        if (child.is_killed || seconds < limits_.seconds) continue;
        child.is_killed = true;
        ::kill(-child.pid, SIGKILL);
    }
}

std::optional<WorkResult> WorkerPool::reap(std::size_t index) {
    const Child child = children_[index];
    int status = 0;
    rusage usage{};
    if (::wait4(child.pid, &status, WNOHANG, &usage) != child.pid) return std::nullopt;
    ::kill(-child.pid, SIGKILL);  // what it may have started itself
    ::close(child.handle);
    children_.erase(children_.begin() + std::ptrdiff_t(index));
    WorkResult result{.job = child.job,
                      .wall_s = std::chrono::duration<double>(Clock::now() - child.start).count(),
                      .cpu_s = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime),
                      .peak_memory_mb = static_cast<double>(usage.ru_maxrss) / 1024};
    const bool is_signalled = WIFSIGNALED(status);
    if (child.is_killed && is_signalled && WTERMSIG(status) == SIGKILL) {
        result.end = WorkEnd::TimedOut;
    } else if (is_signalled) {
        result.end = WorkEnd::Crashed;
        result.signal = WTERMSIG(status);
    } else {
        result.code = WEXITSTATUS(status);
        if (result.code == kOutOfMemoryCode) result.end = WorkEnd::OutOfMemory;
    }
    return result;
}

std::optional<WorkResult> WorkerPool::wait(std::chrono::milliseconds most) {
    const Clock::time_point deadline = Clock::now() + most;
    for (;;) {
        for (std::size_t i = 0; i < children_.size(); ++i) {
            if (std::optional<WorkResult> result = reap(i)) return result;
        }
        kill_late();
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
        if (left.count() <= 0 || children_.empty()) return std::nullopt;
        std::vector<pollfd> handles;
        for (const Child& child : children_) handles.push_back({.fd = child.handle, .events = POLLIN, .revents = 0});
        constexpr int kLongest = 100;  // ms: to look for those whose time is over
        const int ready = ::poll(handles.data(), handles.size(), std::min(kLongest, int(left.count())));
        if (ready < 0 && errno == EINTR) return std::nullopt;
    }
}

}  // namespace selvedge::batch
