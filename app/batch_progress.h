#pragma once
// The progress of a batch: on a terminal one line that is redrawn, in a file a line now and then.
#include <chrono>
#include <cstdio>
#include <string>

#include "app/progress_bar.h"
#include "batch/run.h"

namespace selvedge::app {

// For example "[#####-----] 312 of 1000  52 a minute  13 min left  3 defects, 8 do not fit"; at most `width`
// characters.
std::string batch_line(const batch::BatchCounts& counts, int width);

class BatchProgress {
 public:
    explicit BatchProgress(const ProgressBarOptions& options, std::FILE* stream = stderr)
        : options_(options), stream_(stream) {}
    ~BatchProgress() { finish(); }
    BatchProgress(const BatchProgress&) = delete;
    BatchProgress& operator=(const BatchProgress&) = delete;

    void show(const batch::BatchCounts& counts);
    void finish();  // clears the line

 private:
    using Clock = std::chrono::steady_clock;

    ProgressBarOptions options_;
    std::FILE* stream_;
    bool has_line_ = false;
    Clock::time_point last_{};
};

}  // namespace selvedge::app
