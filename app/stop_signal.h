#pragma once
// Lets a long task end early and cleanly: an interrupt (Ctrl-C) or a request to terminate is noted, and the task looks.
#include <csignal>

namespace selvedge::app {

// While an object of this class exists, SIGINT and SIGTERM set a mark instead of ending the program; a second one of
// them ends it. One object at a time.
class StopSignal {
 public:
    StopSignal();
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    bool is_raised() const;
    // 128 and the signal's number, by which a shell recognises it.
    int exit_code() const;

 private:
    struct sigaction interrupt_ {};
    struct sigaction terminate_ {};
};

}  // namespace selvedge::app
