#pragma once
// The openings of a garment (hems, cuffs, neckline, waist): the closed loops of its boundary, and the limbs that leave
// the garment through each. A limb leaves through the opening whose loop is linked with the line from the torso along
// the limb and on to infinity. The linking number is the number of signed crossings of that line with a surface that
// spans the loop (Gauss; Rolfsen 1976, Knots and Links, 5D).
#include <span>
#include <vector>

#include "sim/core/math.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/place/limbs.h"

namespace selvedge::sim {

// Directed with the garment on its left, seen from the right side of the fabric.
struct Opening {
    std::vector<int> vertices;  // of the sewn mesh, in order; the last is joined to the first
    std::vector<int> panels;    // that it borders, the longest border first
    double length = 0;          // m, in material coordinates
};

// The mean of its vertices; x: by vertex, m.
Vec3d centre_of(const Opening& opening, std::span<const Vec3d> x);

// Pre: the mesh is sewn. The openings of one garment have the order of their first triangles.
std::vector<Opening> find_openings(const GarmentMesh& sewn);

// Which limbs leave a garment through which opening.
struct LimbPassages {
    std::vector<LimbSet> through;  // per opening
    LimbSet known;                 // limbs for which `through` holds; the others were not found, or end in the garment
};

// Where the garment passes through a limb, that limb's part beyond does not count if `ends_at_cloth`; otherwise the
// limb leaves the garment where its end does. `x` holds the position of each vertex of `sewn`, m.
struct PassageOptions {
    bool ends_at_cloth = false;
};
LimbPassages find_passages(const GarmentMesh& sewn, std::span<const Vec3d> x, std::span<const Opening> openings,
                           const BodyLimbs& limbs, const PassageOptions& options = {});

}  // namespace selvedge::sim
