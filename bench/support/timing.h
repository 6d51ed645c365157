#pragma once
// Measures the CPU time of the calling thread over repeated runs, so that other load on the machine has little
// influence.
#include <vector>

namespace selvedge::bench {

double thread_seconds();  // CPU time that the calling thread has used so far, s

struct Timing {
    double median = 0;  // s
    double least = 0;   // s
    int runs = 0;
};

Timing timing_of(const std::vector<double>& seconds);

// CPU time of one call, s. To compare alternatives, run them alternately: call time_once() for each of them inside one
// loop, then timing_of().
template <class Work>
double time_once(Work&& work) {
    const double start = thread_seconds();
    work();
    return thread_seconds() - start;
}

// Calls prepare() and then work(), `runs` times. Only work() is timed.
template <class Prepare, class Work>
Timing time_runs(int runs, Prepare&& prepare, Work&& work) {
    std::vector<double> seconds;
    for (int i = 0; i < runs; ++i) {
        prepare();
        seconds.push_back(time_once(work));
    }
    return timing_of(seconds);
}

// Prevents the compiler from removing the computation of a result that is not used.
template <class T>
void keep(const T& value) {
    asm volatile("" : : "r"(&value) : "memory");
}

}  // namespace selvedge::bench
