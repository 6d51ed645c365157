#include "sim/tartan/best_shift.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace selvedge {
namespace {

constexpr double kSame = 1e-9;  // of the whole cost: sums that differ by less are equal

struct Kink {
    double at = 0;       // m, in [0, repeat]
    double steeper = 0;  // change of slope
};

// value modulo repeat, in [0, repeat).
double phase_of(double value, double repeat) {
    const double phase = value - std::floor(value / repeat) * repeat;
    return phase < repeat ? phase : 0;
}

// Where factor * shift has that phase, within one repeat: once for a factor of 1, twice for 2.
void add_kinks(double phase, int factor, double steeper, double repeat, std::vector<Kink>& kinks) {
    for (int turn = 0; turn < factor; ++turn) kinks.push_back({(phase + turn * repeat) / factor, steeper});
}

}  // namespace

double wrapped(double value, double repeat) {
    return value - std::round(value / repeat) * repeat;
}

double best_shift(const std::vector<ShiftTerm>& terms, double repeat) {
    std::vector<Kink> kinks;
    double cost = 0;
    double slope = 0;  // just before 0
    double scale = 0;
    for (const ShiftTerm& term : terms) {
        const int factor = std::abs(term.factor);
        const double phase = phase_of(term.factor < 0 ? -term.value : term.value, repeat);
        const double weight = term.weight;
        cost += weight * std::min(phase, repeat - phase);
        slope += weight * factor * (phase > 0 && phase <= repeat / 2 ? 1 : -1);
        // Not by phase_of: what rounds to a whole repeat lies there, and not at 0, or the slope before 0 is another.
        const double zero = phase > 0 ? repeat - phase : 0;
        const double farthest = phase <= repeat / 2 ? repeat / 2 - phase : repeat + (repeat / 2 - phase);
        add_kinks(zero, factor, 2 * weight * factor, repeat, kinks);
        add_kinks(farthest, factor, -2 * weight * factor, repeat, kinks);
        scale += weight * repeat;
    }
    std::sort(kinks.begin(), kinks.end(), [](const Kink& a, const Kink& b) { return a.at < b.at; });
    const double now = cost;
    double least = cost;
    std::vector<double> costs;  // at the kinks
    double at = 0;
    for (const Kink& kink : kinks) {
        cost += slope * (kink.at - at);
        at = kink.at;
        slope += kink.steeper;
        costs.push_back(cost);
        least = std::min(least, cost);
    }
    if (now <= least + kSame * scale) return 0;
    double best = repeat;
    for (std::size_t i = 0; i < kinks.size(); ++i) {
        if (costs[i] > least + kSame * scale) continue;
        const double shift = kinks[i].at > repeat / 2 ? kinks[i].at - repeat : kinks[i].at;
        if (std::abs(shift) < std::abs(best) - kSame * repeat) best = shift;
    }
    return best;
}

}  // namespace selvedge
