#pragma once
// A soft switch between 0 and 1.
#include <algorithm>

namespace selvedge {

// 0 below `from`, 1 above `to`, the cubic 3 t^2 - 2 t^3 between.
inline double smoothstep(double x, double from, double to) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

}  // namespace selvedge
