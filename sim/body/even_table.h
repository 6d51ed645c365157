#pragma once
// A function by its values at even steps, straight between them and held beyond the ends: looked up per vertex.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace selvedge {

struct EvenTable {
    double low = 0;              // argument of the first value
    double high = 0;             // and of the last
    std::vector<double> values;  // at least two

    double step() const { return (high - low) / static_cast<double>(values.size() - 1); }

    double at(double x) const {
        const double t = std::clamp((x - low) / step(), 0.0, static_cast<double>(values.size() - 1));
        const auto i = std::min(static_cast<std::size_t>(t), values.size() - 2);
        return std::lerp(values[i], values[i + 1], t - static_cast<double>(i));
    }
};

}  // namespace selvedge
