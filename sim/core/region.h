#pragma once
// A part of space, outside of which work may be left out.
#include <limits>

#include "sim/core/math.h"

namespace selvedge::sim {

using Region = Eigen::AlignedBox3f;  // m

inline Region everywhere() {
    constexpr float kFar = std::numeric_limits<float>::infinity();
    return {Vec3f(-kFar, -kFar, -kFar), Vec3f(kFar, kFar, kFar)};
}

inline Region grown(const Region& region, float by) {
    return {region.min() - Vec3f::Constant(by), region.max() + Vec3f::Constant(by)};
}

}  // namespace selvedge::sim
