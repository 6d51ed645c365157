#pragma once
// Parallel loops (oneTBB). Only loops whose iterations write to disjoint places go through here, so that the result
// has the same bits for any number of threads.
#include <cstddef>
#include <functional>
#include <memory>
#include <string_view>

namespace selvedge::sim {

// Holds the number of threads that parallel loops may use while it lives. Pre: threads >= 1.
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
int allowed_threads();  // by the limits that live

// Calls body(first, last) on disjoint ranges that cover 0..count; none is longer than grain.
void parallel_for(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body);

// How far a long task has come, told to whoever asked: a bar in the terminal, a status line in the editor, nobody.

// phase: a few words ("sewing", "draping"); fraction: 0..1 of that phase.
using Progress = std::function<void(std::string_view phase, double fraction)>;

inline void report(const Progress& progress, std::string_view phase, double fraction) {
    if (progress) progress(phase, fraction);
}

}  // namespace selvedge::sim
