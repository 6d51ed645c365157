#pragma once
// A body whose thighs touch, made of one whose thighs do not.
#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/body/body.h"
#include "sim/core/math.h"

namespace selvedge::sim::test {

// Both legs moved to the middle below the crotch, until their surfaces overlap by this, m, where they are nearest to
// each other. `crotch`: its height, m. Pre: the body stands, and is closed.
inline Body with_touching_thighs(Body body, double crotch, double overlap) {
    const double blend = 0.04;  // m, from the crotch to where the legs have moved by all of it
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3d& x : body.x) {
        if (x.y() < crotch - blend && x.y() > 0.6 * crotch) nearest = std::min(nearest, std::abs(x.x()));
    }
    for (Vec3d& x : body.x) {
        const double share = 1 - smoothstep(x.y(), crotch - blend, crotch);
        if (x.x() != 0) x.x() -= std::copysign(share * (nearest + overlap / 2), x.x());
    }
    body.made_from.clear();
    return body;
}

}  // namespace selvedge::sim::test
