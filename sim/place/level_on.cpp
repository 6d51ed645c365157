#include "sim/place/level_on.h"

#include <cstddef>

namespace selvedge::sim {

double level_on(double y, std::span<const double> from, std::span<const double> to) {
    std::size_t i = 0;
    while (i + 2 < from.size() && y > from[i + 1]) ++i;
    return to[i] + (y - from[i]) * (to[i + 1] - to[i]) / (from[i + 1] - from[i]);
}

}  // namespace selvedge::sim
