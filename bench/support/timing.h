#pragma once
// How long work takes, robust against whatever else the machine does: processor time of the calling thread, over
// repeated runs.
#include <vector>

namespace selvedge::bench {

double thread_seconds();  // processor time that the calling thread has used, s

struct Timing {
    double median = 0;  // s
    double least = 0;   // s
    int runs = 0;
};

Timing timing_of(const std::vector<double>& seconds);

// Calls prepare(), then work(), `runs` times; only work() is timed. For figures to be compared, take them in turns
// instead: time_once in a loop over the rivals, then timing_of.
template <class Work>
double time_once(Work&& work) {
    const double start = thread_seconds();
    work();
    return thread_seconds() - start;
}

template <class Prepare, class Work>
Timing time_runs(int runs, Prepare&& prepare, Work&& work) {
    std::vector<double> seconds;
    for (int i = 0; i < runs; ++i) {
        prepare();
        seconds.push_back(time_once(work));
    }
    return timing_of(seconds);
}

// Keeps a result that nobody reads from being worked out by nobody.
template <class T>
void keep(const T& value) {
    asm volatile("" : : "r"(&value) : "memory");
}

}  // namespace selvedge::bench
