#include "sim/mannequin/curves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "sim/core/assert.h"

namespace selvedge::sim {
namespace {

// Three-point formula, limited to avoid overshoot. h: interval widths, d: interval slopes, both from the end inwards.
double end_slope(double h0, double h1, double d0, double d1) {
    const double slope = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
    if (slope * d0 <= 0) return 0;
    if (d0 * d1 <= 0 && std::abs(slope) > 3 * std::abs(d0)) return 3 * d0;
    return slope;
}

double inner_slope(double h0, double h1, double d0, double d1) {
    if (d0 * d1 <= 0) return 0;
    const double w0 = 2 * h1 + h0;
    const double w1 = h1 + 2 * h0;
    return (w0 + w1) / (w0 / d0 + w1 / d1);
}

}  // namespace

Pchip::Pchip(std::vector<double> x, std::vector<double> y) : x_(std::move(x)), y_(std::move(y)) {
    const std::size_t n = x_.size();
    SELVEDGE_ASSERT(n >= 3 && y_.size() == n);
    std::vector<double> h;
    std::vector<double> d;
    for (std::size_t i = 0; i + 1 < n; ++i) {
        h.push_back(x_[i + 1] - x_[i]);
        SELVEDGE_ASSERT(h.back() > 0);
        d.push_back((y_[i + 1] - y_[i]) / h.back());
    }
    slope_.push_back(end_slope(h[0], h[1], d[0], d[1]));
    for (std::size_t i = 1; i + 1 < n; ++i) slope_.push_back(inner_slope(h[i - 1], h[i], d[i - 1], d[i]));
    slope_.push_back(end_slope(h[n - 2], h[n - 3], d[n - 2], d[n - 3]));
}

double Pchip::operator()(double x) const {
    const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x) - x_.begin();
    const auto i = static_cast<std::size_t>(above) - 1;
    const double h = x_[i + 1] - x_[i];
    const double t = (x - x_[i]) / h;
    const double t2 = t * t;
    const double t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * y_[i] + (t3 - 2 * t2 + t) * h * slope_[i] + (3 * t2 - 2 * t3) * y_[i + 1] +
           (t3 - t2) * h * slope_[i + 1];
}

}  // namespace selvedge::sim
