#include "app/progress_bar.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <sstream>

namespace selvedge::app {
namespace {

constexpr auto kRedrawInterval = std::chrono::milliseconds(50);
constexpr int kPhaseWidth = 12;
constexpr int kLongestBar = 40;
constexpr int kShortestBar = 4;
constexpr int kNumbersWidth = 16;  // "  33 %    4.2 s"

int terminal_width() {
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
    return size.ws_col;
}

bool is_set(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}

bool is_dumb_terminal() {
    const char* terminal = std::getenv("TERM");
    return terminal == nullptr || std::string_view(terminal) == "dumb";
}

double seconds_between(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

std::string bar(double fraction, int length, bool has_colour) {
    const int done = static_cast<int>(std::floor(fraction * length));
    const std::string filled(static_cast<std::size_t>(done), '#');
    const std::string rest(static_cast<std::size_t>(length - done), '-');
    return has_colour ? "[\x1b[32m" + filled + "\x1b[0m" + rest + "]" : "[" + filled + rest + "]";
}

}  // namespace

ProgressBarOptions progress_bar_options(bool is_quiet) {
    const bool is_terminal = isatty(STDERR_FILENO) == 1 && !is_dumb_terminal();
    return {.is_quiet = is_quiet,
            .is_terminal = is_terminal,
            .has_colour = is_terminal && !is_set("NO_COLOR"),
            .width = terminal_width()};
}

std::string progress_line(std::string_view phase, double fraction, double elapsed_s,
                          const ProgressBarOptions& options) {
    // Leave the last column empty: some terminals wrap when it is written.
    const int room = options.width - 1 - kPhaseWidth - kNumbersWidth - 3;
    std::ostringstream line;
    line << std::left << std::setw(kPhaseWidth) << phase.substr(0, kPhaseWidth) << std::right;
    if (room >= kShortestBar) line << ' ' << bar(fraction, std::min(room, kLongestBar), options.has_colour);
    line << std::setw(5) << static_cast<int>(std::floor(fraction * 100)) << " %";
    line << std::fixed << std::setprecision(1) << std::setw(7) << elapsed_s << " s";
    return line.str();
}

ProgressBar::ProgressBar(const ProgressBarOptions& options, std::FILE* stream) : options_(options), stream_(stream) {}

ProgressBar::~ProgressBar() {
    finish();
}

sim::Progress ProgressBar::progress() {
    return [this](std::string_view phase, double fraction) { show(phase, fraction); };
}

void ProgressBar::show(std::string_view phase, double fraction) {
    if (options_.is_quiet) return;
    const auto now = Clock::now();
    if (phase != phase_) {
        end_phase();
        begin_phase(phase, now);
    }
    const bool due = is_due(now, fraction);
    fraction_ = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 0.0;
    if (options_.is_terminal && due) redraw(now);
}

void ProgressBar::finish() {
    end_phase();
}

bool ProgressBar::is_due(Clock::time_point now, double fraction) const {
    return fraction >= 1 || now - last_drawn_ >= kRedrawInterval;
}

void ProgressBar::begin_phase(std::string_view phase, Clock::time_point now) {
    phase_ = phase;
    fraction_ = 0;
    phase_start_ = now;
    last_drawn_ = {};
}

// Prints one line for the finished phase, with its duration.
void ProgressBar::end_phase() {
    if (phase_.empty()) return;
    const double elapsed_s = seconds_between(phase_start_, Clock::now());
    if (options_.is_terminal) std::fputs("\r\x1b[K", stream_);
    std::fprintf(stream_, "%-*s %7.1f s\n", kPhaseWidth, phase_.c_str(), elapsed_s);
    std::fflush(stream_);
    phase_.clear();
}

void ProgressBar::redraw(Clock::time_point now) {
    const std::string line = progress_line(phase_, fraction_, seconds_between(phase_start_, now), options_);
    std::fprintf(stream_, "\r\x1b[K%s", line.c_str());
    std::fflush(stream_);
    last_drawn_ = now;
}

}  // namespace selvedge::app
