#pragma once
// Runs a function that may crash, hang or eat memory in a child process, and takes home the bytes that it returns.
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace selvedge {

struct ChildLimits {
    std::size_t memory_bytes = std::size_t(2) << 30;  // beyond what the program has; not under sanitizers
    int processor_seconds = 20;
    int wall_seconds = 30;
    std::size_t answer_bytes = std::size_t(1) << 30;
};

enum class ChildEnd { Done, Crashed, TimedOut, TooMuch, NotStarted };

struct ChildResult {
    ChildEnd end = ChildEnd::Done;
    std::string answer;  // whole when Done
};

// The child is a fork without exec: it has this program's memory but only the calling thread, so `work` must start no
// parallel loops and take no locks that other threads of ours hold. The allocator's locks are made good by the C
// library; should another one (a locale's, a stream's) be held at the moment of the fork, the child waits for it and
// ends as TimedOut: the parent is never at risk. The child's own output goes nowhere.
ChildResult run_in_child(const std::function<std::string()>& work, const ChildLimits& limits = {});

}  // namespace selvedge
