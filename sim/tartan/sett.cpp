#include "sim/tartan/sett.h"

#include <algorithm>
#include <cmath>

#include "sim/core/assert.h"

namespace selvedge {
namespace {

int count_threads(const std::vector<SettStripe>& stripes) {
    int count = 0;
    for (const SettStripe& stripe : stripes) count += stripe.threads;
    return count;
}

std::vector<Rgb8> colours_of(const std::vector<SettStripe>& stripes) {
    std::vector<Rgb8> colours;
    for (const SettStripe& stripe : stripes) {
        colours.insert(colours.end(), static_cast<std::size_t>(stripe.threads), stripe.colour);
    }
    return colours;
}

}  // namespace

const std::vector<SettStripe>& weft_stripes(const Sett& sett) {
    return sett.weft_stripes.empty() ? sett.stripes : sett.weft_stripes;
}

int thread_count(const Sett& sett) {
    return count_threads(sett.stripes);
}

int weft_thread_count(const Sett& sett) {
    return count_threads(weft_stripes(sett));
}

double repeat_size(const Sett& sett) {
    return thread_count(sett) * sett.thread_spacing;
}

double weft_repeat_size(const Sett& sett) {
    return weft_thread_count(sett) * sett.thread_spacing;
}

std::vector<Rgb8> thread_colours(const Sett& sett) {
    return colours_of(sett.stripes);
}

std::vector<Rgb8> weft_thread_colours(const Sett& sett) {
    return colours_of(weft_stripes(sett));
}

Sett with_repeat_size(Sett sett, double size) {
    SELVEDGE_ASSERT(size > 0 && !sett.stripes.empty());
    const int threads = thread_count(sett);
    const int most = std::max(1, kMaxSettThreads / std::max(threads, weft_thread_count(sett)));
    const int factor = std::clamp(static_cast<int>(std::lround(size / (threads * sett.thread_spacing))), 1, most);
    for (SettStripe& stripe : sett.stripes) stripe.threads *= factor;
    for (SettStripe& stripe : sett.weft_stripes) stripe.threads *= factor;
    sett.thread_spacing = size / (threads * factor);
    return sett;
}

}  // namespace selvedge
