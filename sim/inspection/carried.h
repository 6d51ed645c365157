#pragma once
// Whether a body carries cloth that goes round none of its limbs, as a scarf.
#include <span>

#include "sim/body/body.h"

namespace selvedge::sim {

// Whether one of the points of the cloth lies on a surface of the body that faces up, above that height, m: as on a
// shoulder.
bool is_carried(std::span<const Vec3d> points, const Body& body, double above);

}  // namespace selvedge::sim
