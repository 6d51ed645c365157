#pragma once
// Checks whether a draped garment is worn as its pattern was placed: each opening (hem, cuff, neckline, waist) holds
// the limbs that it was placed for, each panel lies on the part of the body over which it was placed, and no waist or
// upper edge has slipped below the hips or the bust that should hold it. What was meant is read from the panels as they
// stand, unsewn, round the body for which they were placed; so the body that wears the garment may have another size
// and pose.
#include <vector>

#include "sim/body/body.h"
#include "sim/cloth/cloth.h"
#include "sim/dress/report.h"
#include "sim/mesh/garment_mesh.h"

namespace selvedge::sim {

// A garment as its designer placed it.
struct DesignedGarment {
    GarmentMesh unsewn;
    const Body* body = nullptr;  // for which it was placed
};

// Adds the faults "limb_missed", "displaced", "does_not_fit" (what is too large or too stretchy to hang where it was
// placed) and "on_floor" to the report, and notes on what could not be checked.
// `sewn` is the mesh from which the cloth was made. Pre: it has the triangles of the designed garment, in their order;
// the cloth's positions are finite; the report has the faces inside the body.
void validate_wearing(const Cloth& cloth, const GarmentMesh& sewn, const DesignedGarment& designed, const Body& wearer,
                      DressReport& report);

}  // namespace selvedge::sim
