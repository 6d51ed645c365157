#pragma once
// Where a camera that follows a moving body is over the floor, at any time of an animation.
#include <vector>

#include "sim/core/math.h"
#include "sim/session/animation.h"

namespace selvedge::app {

// The mean of where the body's middle is from kAhead before a time to kAhead behind it: the camera neither sways with
// each step nor lags behind, because the whole motion is known beforehand.
class CameraPath {
 public:
    explicit CameraPath(const sim::Animation& animation);

    Vec3f at(double seconds) const;  // m; y is 0

 private:
    static constexpr double kAhead = 0.4;  // s, a third of a walking person's stride

    std::vector<Vec3f> keys_;  // the means, at equal times from 0 on
    double interval_ = 1;      // s
};

}  // namespace selvedge::app
