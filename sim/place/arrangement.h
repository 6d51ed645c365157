#pragma once
// Arrangement points: places round a body at which a panel can be put, wrapped round what is there.
// They follow from the body's sections, and from its skeleton where it has one (arms, legs).
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

struct ArrangementPoint {
    std::string name;                // "chest front", "left upper arm outside"
    Vec3d position = Vec3d::Zero();  // m, on the cylinder about the limb or torso, clear of the body
    Vec3d outward = Vec3d::UnitZ();  // unit, from the axis
    Vec3d upward = Vec3d::UnitY();   // unit, along the axis, towards the head or shoulder or hip
    double radius = 0;               // m, of that cylinder, clear of the body
};

// In a fixed order: torso from neck to below the hip, then arms, then legs; at each level front, back, left, right.
std::vector<ArrangementPoint> arrangement_points(const Body& body);

// Puts the panel's middle (of the box about its outline) at the point, right side outward, its +y along `upward`, and
// wraps it round the cylinder.
void arrange(Panel& panel, const ArrangementPoint& point);

}  // namespace selvedge::sim
