#pragma once
// Scalar functions for the mannequin: monotone piecewise cubic interpolation without overshoot (Fritsch and Carlson
// 1980; Fritsch and Butland 1984: weighted harmonic mean of slopes), tables with uniform steps, and smoothstep.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace selvedge::sim {

class Pchip {
 public:
    // Pre: at least 3 points, x strictly increasing.
    Pchip(std::vector<double> x, std::vector<double> y);

    // Outside the interval the first or last cubic is extrapolated.
    double operator()(double x) const;

 private:
    std::vector<double> x_;
    std::vector<double> y_;
    std::vector<double> slope_;
};

// A function given by its values at uniform steps: linear in between, constant outside. Cheap enough to evaluate per
// vertex.

struct EvenTable {
    double low = 0;              // argument of the first value
    double high = 0;             // argument of the last value
    std::vector<double> values;  // at least two

    double step() const { return (high - low) / static_cast<double>(values.size() - 1); }

    double at(double x) const {
        const double t = std::clamp((x - low) / step(), 0.0, static_cast<double>(values.size() - 1));
        const auto i = std::min(static_cast<std::size_t>(t), values.size() - 2);
        return std::lerp(values[i], values[i + 1], t - static_cast<double>(i));
    }
};

// Smooth step between 0 and 1.

// 0 below `from`, 1 above `to`, the cubic 3 t^2 - 2 t^3 between.
inline double smoothstep(double x, double from, double to) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

}  // namespace selvedge::sim
