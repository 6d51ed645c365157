#pragma once
// Bends the base body to one set of shape parameters: each vertex goes to the weighted mean of where torso, head,
// limbs, hands and feet would take it.
#include <vector>

#include "sim/body/mannequin_torso.h"

namespace selvedge {

struct BentBody {
    std::vector<Vec3d> x;
    Landmarks landmarks;
};

BentBody bend_body(const MannequinBase& base, const ShapeParameters& shape);

// Upper and lower arm along their bones, m.
double arm_length(const Joints& joints);

}  // namespace selvedge
