#pragma once
// Where a plane cuts a garment: closed loops, with their lengths in the cloth as it was cut out, so that stretch does
// not count.
#include <vector>

#include "sim/body/section.h"
#include "sim/core/math.h"
#include "sim/mesh/draw_mesh.h"

namespace selvedge::sim {

struct GarmentLoop {
    std::vector<Vec3d> points;  // m, in order round the loop
    double girth = 0;           // m, in material coordinates
    double limit_girth = 0;     // m, the same with each panel stretched to its fabric's limit
};

// The closed loops in which the plane cuts the garment, in a deterministic order; open sections are left out.
// strain_limits: of each panel's fabric; empty: 0. Pre: triangles have corner material coordinates; positions are
// finite.
std::vector<GarmentLoop> cut_garment(const DrawMesh& garment, const Plane& plane,
                                     const std::vector<double>& strain_limits = {});

// Whether a loop in this plane encloses the point, which lies in the plane: its winding number is not 0.
// Folded cloth may intersect itself, but not as far in as the centre of a body section. (Sunday 2001)
bool goes_round(const std::vector<Vec3d>& loop, const Plane& plane, const Vec3d& point);

}  // namespace selvedge::sim
