#pragma once
// Checks whether a draped garment is worn as its pattern was placed: each opening (hem, cuff, neckline, waist) holds
// the limbs that it was placed for, each panel lies on the part of the body over which it was placed, and no waist or
// upper edge has slipped below the hips or the bust that should hold it. What was meant is read from the unsewn panels
// round the body for which they were placed, raised to its shoulders if they stand lower (hang_on_shoulders); so the
// body that wears the garment may have another size and pose.
#include <memory>

#include "sim/cloth/cloth.h"
#include "sim/inspection/report.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/pattern.h"
#include "sim/place/measured_body.h"

namespace selvedge::sim {

// A garment as its designer placed it.
struct DesignedGarment {
    GarmentMesh unsewn;
    const Pattern* pattern = nullptr;    // of the mesh; not read after the check is made
    const MeasuredBody* body = nullptr;  // for which it was placed
};

// What is known of a garment and its bodies before it is draped is found once, for all checks of its drape.
class WearingCheck {
 public:
    // sewn: the mesh from which the cloth is made. Pre: it has the triangles of the designed garment, in their order;
    // it and the bodies live as long.
    WearingCheck(const GarmentMesh& sewn, DesignedGarment designed, const MeasuredBody& wearer);

    // Whether a waist or upper edge lies below the hips or the bust because it is too large or too stretchy to hang
    // where it was placed: nothing holds it there, so it slips on. False for what hangs from the shoulders. Pre: the
    // cloth's positions are finite.
    bool slips(const Cloth& cloth) const;

    // Adds the faults "limb_missed", "displaced", "does_not_fit" (what slips) and "on_floor" to the report, and notes
    // on what could not be checked. What slips is not also displaced or on the floor. Pre: the cloth's positions are
    // finite; the report has the faces inside the body.
    void validate(const Cloth& cloth, DressReport& report) const;

 private:
    struct Known;
    std::shared_ptr<const Known> known_;
};

}  // namespace selvedge::sim
