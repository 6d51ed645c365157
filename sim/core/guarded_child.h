#pragma once
// Runs a function that may crash, hang or exhaust memory in a child process and returns the bytes that it produces. The
// readers of files that others' libraries parse ask it.
#include <cstddef>
#include <functional>
#include <string>

namespace selvedge::sim {

struct ChildLimits {
    std::size_t memory_bytes = std::size_t(2) << 30;  // on top of what is in use; not applied under AddressSanitizer
    int processor_seconds = 20;
    int wall_seconds = 30;
    std::size_t answer_bytes = std::size_t(1) << 30;
};

enum class ChildEnd { Done, Crashed, Forbidden, TimedOut, TooMuch, NotStarted };

struct ChildResult {
    ChildEnd end = ChildEnd::Done;
    std::string answer;  // complete when end is Done
};

// The child is a fork without exec. It has a copy of this program's memory but only the calling thread, so `work` must
// not start parallel loops or take locks that other threads of the program may hold; and none of the files and sockets
// that this program has open, so `work` opens what it reads. The C library resets the allocator's locks. If another
// lock (of a locale or a stream) is held at the fork, the child blocks and ends as TimedOut; the parent is never at
// risk. The child's standard output and error go to /dev/null. It may read files, and ends as Forbidden if it writes
// one, opens a socket or starts a program (sim/core/system_call_filter.h), except where the kernel has no such
// filters.
ChildResult run_in_child(const std::function<std::string()>& work, const ChildLimits& limits = {});

// What `work`, which reads `file`, answers in a child. Throws InputError, or PassingError where another try may
// succeed, when the child ends in another way.
std::string answer_of_child(const std::function<std::string()>& work, const std::string& file,
                            const ChildLimits& limits);

// Throws PassingError if `failure`, the message of an exception in the child, says that memory ran out.
void check_memory_of_child(const std::string& failure, const std::string& file);

}  // namespace selvedge::sim
