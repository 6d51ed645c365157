#pragma once
// Arrangement points: positions around a body at which a panel can be placed, wrapped on a cylinder about the torso or
// limb. They are computed from plane sections of the body and, where it has one, its skeleton (arms, legs).
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

struct ArrangementPoint {
    std::string name;                // "chest front", "left upper arm outside"
    Vec3d position = Vec3d::Zero();  // m, on the cylinder about the limb or torso, clear of the body
    Vec3d outward = Vec3d::UnitZ();  // unit, away from the axis
    Vec3d upward = Vec3d::UnitY();   // unit, along the axis, towards the head, shoulder or hip
    double radius = 0;               // m, of that cylinder
};

// All points in a fixed order: torso from neck to below the hip, then arms, then legs; at each torso level front, back,
// left, right. Points too close to the body are left out.
std::vector<ArrangementPoint> arrangement_points(const Body& body);

// Places the centre of the panel's bounding box at the point, right side outward, the panel's +y along `upward`, and
// wraps the panel around the cylinder.
void arrange(Panel& panel, const ArrangementPoint& point);

}  // namespace selvedge::sim
