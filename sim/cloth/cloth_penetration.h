#pragma once
// The leaves of a cloth that are inside a body (sim/collide/penetration.h).
#include "sim/collide/penetration.h"

namespace selvedge::sim {

struct Cloth;

// Triangles are numbered as the leaves of the mesh. Pre: as find_penetration().
Penetration find_penetration(const Cloth& cloth, const SurfaceBvh& surface, const PenetrationOptions& options);

}  // namespace selvedge::sim
