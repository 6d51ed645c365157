#include "app/batch_progress.h"

#include <algorithm>
#include <cmath>

namespace selvedge::app {
namespace {

// "13 min", "40 s", "3.2 h".
std::string duration_text(double seconds) {
    char text[32];
    if (seconds < 99.5) {
        std::snprintf(text, sizeof text, "%.0f s", seconds);
    } else if (seconds < 99.5 * 60) {
        std::snprintf(text, sizeof text, "%.0f min", seconds / 60);
    } else {
        std::snprintf(text, sizeof text, "%.1f h", seconds / 3600);
    }
    return text;
}

void add_count(std::size_t count, const char* what, std::string& text) {
    if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + what;
}

}  // namespace

std::string batch_line(const batch::BatchCounts& counts, int width) {
    const std::size_t done = counts.skipped + counts.done;
    const double fraction = counts.jobs == 0 ? 1 : static_cast<double>(done) / static_cast<double>(counts.jobs);
    constexpr std::size_t kCells = 20;
    const auto filled = static_cast<std::size_t>(std::lround(fraction * kCells));
    std::string line = "[" + std::string(filled, '#') + std::string(kCells - filled, '-') + "] " +
                       std::to_string(done) + " of " + std::to_string(counts.jobs);
    if (counts.done > 0 && counts.seconds > 0) {
        const double rate = static_cast<double>(counts.done) / counts.seconds;
        char text[48];
        std::snprintf(text, sizeof text, "  %.*f a minute", rate < 1 ? 1 : 0, 60 * rate);
        line += text;
        if (done < counts.jobs) line += "  " + duration_text(static_cast<double>(counts.jobs - done) / rate) + " left";
    }
    std::string faults;
    add_count(counts.defects, counts.defects == 1 ? "defect" : "defects", faults);
    add_count(counts.does_not_fit, counts.does_not_fit == 1 ? "does not fit" : "do not fit", faults);
    add_count(counts.refused, "refused", faults);
    add_count(counts.failed, "failed", faults);
    if (!faults.empty()) line += "  " + faults;
    if (line.size() > static_cast<std::size_t>(width)) line.resize(static_cast<std::size_t>(width));
    return line;
}

void BatchProgress::show(const batch::BatchCounts& counts) {
    if (options_.is_quiet) return;
    counts_ = counts;
    if (!options_.is_terminal && done_when_drawn_ == counts.skipped + counts.done) return;
    const auto pause = options_.is_terminal ? std::chrono::milliseconds(100) : std::chrono::milliseconds(5000);
    if (!last_ || Clock::now() - *last_ >= pause || counts.is_complete()) draw();
}

void BatchProgress::draw() {
    last_ = Clock::now();
    done_when_drawn_ = counts_->skipped + counts_->done;
    const std::string line = batch_line(*counts_, std::max(20, options_.width - 1));
    if (options_.is_terminal) {
        std::fprintf(stream_, "\r%s\033[K", line.c_str());
        has_line_ = true;
    } else {
        std::fprintf(stream_, "%s\n", line.c_str());
    }
    std::fflush(stream_);
}

void BatchProgress::finish() {
    const bool lacks_last = counts_ && done_when_drawn_ != counts_->skipped + counts_->done;
    if (lacks_last && !options_.is_terminal) draw();
    if (has_line_) std::fprintf(stream_, "\r\033[K");
    std::fflush(stream_);
    has_line_ = false;
}

}  // namespace selvedge::app
