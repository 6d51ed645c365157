#include "sim/inspection/body_heights.h"

#include <algorithm>
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

}  // namespace selvedge::sim
