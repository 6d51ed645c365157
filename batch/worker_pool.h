#pragma once
// Child processes, one per job, that do their work beside each other: a crash, a hang or a job that exhausts its memory
// ends its own process and nothing else.
#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace selvedge::batch {

struct JobLimits {
    double seconds = 300;                             // of wall time
    std::size_t memory_bytes = std::size_t(4) << 30;  // of address space, on top of the program's own; 0: no limit
};

enum class WorkEnd { Exited, Crashed, TimedOut, OutOfMemory };

// How the work of one job ended, and what it took.
struct WorkResult {
    std::size_t job = 0;
    WorkEnd end = WorkEnd::Exited;
    int code = 0;    // exit code, if it exited
    int signal = 0;  // that ended it, if it crashed
    double wall_s = 0;
    double cpu_s = 0;
    double peak_memory_mb = 0;
};

class WorkerPool {
 public:
    explicit WorkerPool(const JobLimits& limits) : limits_(limits) {}
    ~WorkerPool();  // kills what still runs
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    std::size_t running() const { return children_.size(); }

    // Starts a child that runs `work` and exits with the code that it returns. What it prints goes into the file `log`,
    // also the message of an exception, which exits 2. The child ends when this process does. False if the system has
    // no process or memory left for one now. Throws InputError if none can be started at all. Pre: this process has
    // started no threads.
    bool start(std::size_t job, const std::filesystem::path& log, const std::function<int()>& work);

    // Waits up to `most` for a child to end; nullopt if none did. Kills those whose time is over.
    std::optional<WorkResult> wait(std::chrono::milliseconds most);

 private:
    using Clock = std::chrono::steady_clock;
    struct Child {
        std::size_t job = 0;
        pid_t pid = -1;
        int handle = -1;  // pidfd
        Clock::time_point start;
        bool is_killed = false;  // for its time
    };

    void kill_late();
    std::optional<WorkResult> reap(std::size_t index);

    JobLimits limits_;
    std::vector<Child> children_;
};

}  // namespace selvedge::batch
