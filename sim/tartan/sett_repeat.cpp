#include "sim/tartan/sett_repeat.h"

#include <cstddef>

namespace selvedge {
namespace {

// Neighbouring stripes of one colour are one, also the last and the first.
struct Runs {
    std::vector<SettStripe> runs;
    int start = 0;  // threads before the first run
};

Runs merge_runs(const std::vector<SettStripe>& stripes) {
    Runs merged;
    for (const SettStripe& stripe : stripes) {
        if (!merged.runs.empty() && merged.runs.back().colour == stripe.colour) {
            merged.runs.back().threads += stripe.threads;
        } else {
            merged.runs.push_back(stripe);
        }
    }
    if (merged.runs.size() > 1 && merged.runs.back().colour == merged.runs.front().colour) {
        merged.start = -merged.runs.back().threads;
        merged.runs.front().threads += merged.runs.back().threads;
        merged.runs.pop_back();
    }
    return merged;
}

bool is_same(const SettStripe& a, const SettStripe& b) {
    return a.colour == b.colour && a.threads == b.threads;
}

bool repeats_after(const std::vector<SettStripe>& runs, std::size_t count) {
    for (std::size_t i = count; i < runs.size(); ++i) {
        if (!is_same(runs[i], runs[i - count])) return false;
    }
    return true;
}

bool mirrors_about(const std::vector<SettStripe>& runs, std::size_t middle) {
    const std::size_t count = runs.size();
    for (std::size_t k = 1; 2 * k <= count; ++k) {
        if (!is_same(runs[(middle + k) % count], runs[(middle + count - k) % count])) return false;
    }
    return true;
}

StripeRepeat repeat_of(const std::vector<SettStripe>& stripes, double spacing) {
    Runs merged = merge_runs(stripes);
    StripeRepeat repeat;
    if (merged.runs.size() < 2) return repeat;
    for (std::size_t count = 2; count < merged.runs.size(); ++count) {
        if (merged.runs.size() % count != 0 || !repeats_after(merged.runs, count)) continue;
        merged.runs.resize(count);
        break;
    }
    int threads = 0;
    for (std::size_t i = 0; i < merged.runs.size(); ++i) {
        if (!repeat.mirror && mirrors_about(merged.runs, i)) {
            repeat.mirror = (merged.start + threads + 0.5 * merged.runs[i].threads) * spacing;
        }
        threads += merged.runs[i].threads;
    }
    repeat.size = threads * spacing;
    return repeat;
}

}  // namespace

StripeRepeat warp_repeat(const Sett& sett) {
    return repeat_of(sett.stripes, sett.thread_spacing);
}

StripeRepeat weft_repeat(const Sett& sett) {
    return repeat_of(weft_stripes(sett), sett.thread_spacing);
}

}  // namespace selvedge
