#pragma once
// A tangent plane of a body's surface. It moves and turns with the surface during a step; that of a body at rest does
// not.
#include "sim/core/math.h"

namespace selvedge::sim {

// The body is on the side that the normal points away from.
struct TangentPlane {
    Vec3f point = Vec3f::Zero();   // on the surface, at the start of the step, m
    Vec3f motion = Vec3f::Zero();  // of that point until the end of the step, m
    Vec3f normal = Vec3f::Zero();  // unit, at the start
    Vec3f turn = Vec3f::Zero();    // change of the normal until the end
};

// That plane at one moment of the step, a share of it.
struct PlaneNow {
    Vec3f normal = Vec3f::Zero();
    float height = 0;  // of a point above the plane, m
};
PlaneNow plane_now(const TangentPlane& plane, const Vec3f& x, float share);

}  // namespace selvedge::sim
