#pragma once
// Parallel loops (oneTBB), a scoped limit on the number of threads, and progress callbacks for long tasks.
// Iterations of a parallel loop must write to disjoint memory; then the result is bit-identical for any thread count.
#include <cstddef>
#include <functional>
#include <memory>
#include <string_view>

namespace selvedge::sim {

// Limits the number of threads that parallel loops use during its lifetime. Pre: threads >= 1.
class ThreadLimit {
 public:
    explicit ThreadLimit(int threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

int available_threads();
int allowed_threads();  // under the limits in force

// Calls body(first, last) on disjoint ranges [first, last) that cover [0, count). No range is longer than grain.
// Pre: grain > 0.
void parallel_for(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body);

// Ends the threads that parallel loops keep; the next loop starts new ones. For fork(): a child has none of its
// parent's threads, and a loop there would take them for working ones and start none. Does nothing where another thread
// may be in a loop.
void end_worker_threads();

// A callback that receives the progress of a long task, for example to draw a progress bar. May be empty.
// phase: a short label ("sewing", "draping"); fraction: the completed part of that phase, 0..1.
using Progress = std::function<void(std::string_view phase, double fraction)>;

inline void report(const Progress& progress, std::string_view phase, double fraction) {
    if (progress) progress(phase, fraction);
}

}  // namespace selvedge::sim
