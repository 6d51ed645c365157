#pragma once
// The leaves of a cloth that are inside a body (sim/collide/penetration.h).
#include "sim/collide/penetration.h"

namespace selvedge::sim {

struct Cloth;

inline constexpr double kFaceDip =
    0.003;  // m, of an edge or face in the body: more than the solver lets one dip in motion

// Triangles are numbered as the leaves of the mesh. Pre: as find_penetration().
Penetration find_penetration(const Cloth& cloth, const SurfaceBvh& surface, const PenetrationOptions& options);

}  // namespace selvedge::sim
