#include "editor/inspectors/drape_text.h"

#include <algorithm>
#include <cstdio>

namespace selvedge {
namespace {

std::string printed(const char* format, double value) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

}  // namespace

std::string stage_words(SessionStage stage, bool is_running) {
    switch (stage) {
        case SessionStage::Empty:
            return "Empty: there is nothing to drape";
        case SessionStage::Placed:
            return is_running ? "Panels are taken up" : "Placed: panels stand round the body";
        case SessionStage::Sewing:
            return is_running ? "Sewing: seams close" : "Sewing, paused";
        case SessionStage::Draping:
            return is_running ? "Draping: the garment falls" : "Draping, paused";
        case SessionStage::Settled:
            return "Settled: it hangs still";
        case SessionStage::Failed:
            break;
    }
    return "Failed: it cannot go on";
}

std::string seconds_text(double seconds) {
    return printed("%.1f s", seconds);
}

std::string milliseconds_text(double milliseconds) {
    return printed(milliseconds < 10 ? "%.2f ms" : "%.1f ms", milliseconds);
}

std::string speed_text(double metres_per_second) {
    return printed("%.1f cm/s", 100 * metres_per_second);
}

std::string count_text(int count) {
    std::string text = std::to_string(count);
    for (std::size_t i = text.size(); i > 3 && text[i - 4] != '-'; i -= 3) text.insert(i - 3, ",");
    return text;
}

CurvatureOptions curvature_with(CurvatureOptions options, std::optional<double> split, std::optional<double> rejoin) {
    constexpr float kBelow = 0.95F;
    if (split) {
        options.split_angle = static_cast<float>(*split);
        options.rejoin_angle = std::min(options.rejoin_angle, kBelow * options.split_angle);
    }
    if (rejoin) options.rejoin_angle = std::min(static_cast<float>(*rejoin), kBelow * options.split_angle);
    return options;
}

std::string free_drape_name(const std::vector<std::string>& kept, const std::string& wanted) {
    const std::string base = wanted.empty() ? "drape" : wanted;
    std::string name = base;
    for (int number = 2; std::find(kept.begin(), kept.end(), name) != kept.end(); ++number) {
        name = base + " " + std::to_string(number);
    }
    return name;
}

}  // namespace selvedge
