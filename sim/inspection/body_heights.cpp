#include "sim/inspection/body_heights.h"

#include <algorithm>
#include <cstddef>
#include <functional>

namespace selvedge::sim {

Heights heights_of(const BodyLimbs& body) {
    Heights heights{body.height.low};
    for (const LimbJoint& joint : body.torso) heights.push_back(joint.centre.y());
    heights.push_back(body.height.high);
    return heights;
}

bool is_ascending(const Heights& heights) {
    return std::ranges::adjacent_find(heights, std::greater_equal<>()) == heights.end();
}

double carry_over(double y, const Heights& from, const Heights& to) {
    std::size_t i = 0;
    while (i + 2 < from.size() && y > from[i + 1]) ++i;
    return to[i] + (y - from[i]) * (to[i + 1] - to[i]) / (from[i + 1] - from[i]);
}

}  // namespace selvedge::sim
