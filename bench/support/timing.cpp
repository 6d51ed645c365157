#include "bench/support/timing.h"

#include <algorithm>
#include <ctime>

#include "sim/core/math.h"

namespace selvedge::bench {
double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Timing timing_of(const std::vector<double>& seconds) {
    if (seconds.empty()) return {};
    return {.median = sim::quantile(seconds, 0.5),
            .least = *std::min_element(seconds.begin(), seconds.end()),
            .runs = static_cast<int>(seconds.size())};
}

}  // namespace selvedge::bench
