#pragma once
// A progress bar for long tasks (sim/core/parallel.h): redraws one line in place on a terminal; writes one line per
// phase if the output is a file. Writes to stderr, so that stdout holds results only.
#include <chrono>
#include <cstdio>
#include <string>
#include <string_view>

#include "sim/core/parallel.h"

namespace selvedge::app {

struct ProgressBarOptions {
    bool is_quiet = false;     // shows nothing
    bool is_terminal = false;  // the line can be redrawn in place
    bool has_colour = false;   // the bar may be coloured
    int width = 80;            // of the terminal, characters
};

// Options for stderr: no redrawing on a file or a dumb terminal; no colour if NO_COLOR is set.
ProgressBarOptions progress_bar_options(bool is_quiet);

// For example "draping   [########----------------]  33 %   4.2 s"; at most `width` characters. Pre: 0 <= fraction <=
// 1.
std::string progress_line(std::string_view phase, double fraction, double elapsed_s, const ProgressBarOptions& options);

// Owns the terminal's line from the first report on; finish() or the destructor clears it.
class ProgressBar {
 public:
    explicit ProgressBar(const ProgressBarOptions& options, std::FILE* stream = stderr);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(std::string_view phase, double fraction);
    void finish();

    // A callback for a task that ends before this object does.
    sim::Progress progress();

 private:
    using Clock = std::chrono::steady_clock;

    bool is_due(Clock::time_point now, double fraction) const;
    void begin_phase(std::string_view phase, Clock::time_point now);
    void end_phase();
    void redraw(Clock::time_point now);

    ProgressBarOptions options_;
    std::FILE* stream_;
    std::string phase_;
    double fraction_ = 0;
    Clock::time_point phase_start_;
    Clock::time_point last_drawn_;
};

}  // namespace selvedge::app
