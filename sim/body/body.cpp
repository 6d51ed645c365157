#include "sim/body/body.h"

#include <algorithm>

namespace selvedge::sim {

HeightRange height_range(const Body& body) {
    if (body.x.empty()) return {};
    HeightRange range{.low = body.x.front().y(), .high = body.x.front().y()};
    for (const Vec3d& x : body.x) {
        range.low = std::min(range.low, x.y());
        range.high = std::max(range.high, x.y());
    }
    return range;
}

}  // namespace selvedge::sim
