#pragma once
// Shows on the terminal how far a long task has come (sim/core/parallel.h): one line redrawn in place on a terminal,
// one line per phase where the output goes to a file. Written to stderr, so that stdout stays the program's answer.
#include <chrono>
#include <cstdio>
#include <string>
#include <string_view>

#include "sim/core/parallel.h"

namespace selvedge::app {

struct ProgressBarOptions {
    bool is_quiet = false;     // shows nothing at all
    bool is_terminal = false;  // the line can be redrawn in place
    bool has_colour = false;   // the bar may be coloured
    int width = 80;            // of the terminal, characters
};

// What stderr and the environment ask for: no redrawing where it is no terminal or a dumb one, no colour with NO_COLOR.
ProgressBarOptions progress_bar_options(bool is_quiet);

// "draping   [########----------------]  33 %   4.2 s", not wider than width. Pre: 0 <= fraction <= 1.
std::string progress_line(std::string_view phase, double fraction, double elapsed_s, const ProgressBarOptions& options);

// Owns the terminal's line from the first report to its end: finish() or the destructor leave it clean.
class ProgressBar {
 public:
    explicit ProgressBar(const ProgressBarOptions& options, std::FILE* stream = stderr);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(std::string_view phase, double fraction);
    void finish();

    // To be handed to a task that ends before the bar does.
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
