#include "sim/tartan/sett.h"

#include <algorithm>
#include <cmath>

#include "sim/core/assert.h"

namespace selvedge {

int thread_count(const Sett& sett) {
    int count = 0;
    for (const SettStripe& stripe : sett.stripes) count += stripe.threads;
    return count;
}

double repeat_size(const Sett& sett) {
    return thread_count(sett) * sett.thread_spacing;
}

std::vector<Rgb8> thread_colours(const Sett& sett) {
    std::vector<Rgb8> colours;
    for (const SettStripe& stripe : sett.stripes) {
        colours.insert(colours.end(), static_cast<std::size_t>(stripe.threads), stripe.colour);
    }
    return colours;
}

Sett with_repeat_size(Sett sett, double size) {
    SELVEDGE_ASSERT(size > 0 && !sett.stripes.empty());
    const int threads = thread_count(sett);
    const int most = std::max(1, kMaxSettThreads / threads);
    const int factor = std::clamp(static_cast<int>(std::lround(size / (threads * sett.thread_spacing))), 1, most);
    for (SettStripe& stripe : sett.stripes) stripe.threads *= factor;
    sett.thread_spacing = size / (threads * factor);
    return sett;
}

}  // namespace selvedge
