#pragma once
// How far a panel, where it is placed, is from the body.
#include "sim/collide/body_collider.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// From the nearest of a net of points on the panel, its outline among them, to the body, m; negative inside.
float clearance_of(const Panel& panel, const BodyCollider& body);

}  // namespace selvedge::sim
