#pragma once
// Order statistics of a handful of figures.
#include <algorithm>
#include <cstddef>
#include <vector>

namespace selvedge {

// The value below which the share q (0..1) of the others lies: one of them, none in between. 0 when there are none.
inline double quantile(std::vector<double> values, double q) {
    if (values.empty()) return 0;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

}  // namespace selvedge
