#pragma once
// The progress of a batch: on a terminal one line that is redrawn, in a file or pipe a line every few seconds in which
// jobs ended, and one for the end.
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <optional>
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
    void finish();  // clears the line; in a file, writes the last one if that is still to come

 private:
    using Clock = std::chrono::steady_clock;

    void draw();

    ProgressBarOptions options_;
    std::FILE* stream_;
    bool has_line_ = false;
    std::optional<Clock::time_point> last_{};       // of what was drawn
    std::optional<batch::BatchCounts> counts_{};    // as they are now
    std::optional<std::size_t> done_when_drawn_{};  // jobs
};

}  // namespace selvedge::app
