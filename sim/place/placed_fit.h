#pragma once
// Whether a garment is much too small for a body, found from its panels as they stand round it, before they are sewn:
// what cannot close round the body ends anywhere else, and its drape does not show why.
#include <optional>
#include <vector>

#include "sim/mesh/garment_mesh.h"
#include "sim/place/fit.h"
#include "sim/place/measured_body.h"

namespace selvedge::sim {

struct PlacedFitOptions {
    double slide = 0.10;                  // m, by which a garment may end higher or lower than its panels stand
    double excess = 0.12;                 // relative, by which it must be smaller, stretched to its fabrics' limits
    std::vector<double> strain_limits{};  // of the fabric, per panel; empty: 0
};

// Where the garment, with its seams closed, is smaller than the body by most, relatively, between crotch and armpits,
// on an upper arm or on a thigh: its largest loop round that part within reach of there is compared with the smallest
// girth of the part. None if it is nowhere by more than the excess. unsewn: its panels placed round the body.
std::optional<TightLevel> too_small_as_placed(const GarmentMesh& unsewn, const MeasuredBody& body,
                                              const PlacedFitOptions& options = {});

// How far the lowest point of the panels stands below the floor, m; 0 if it does not.
double depth_below_floor(const GarmentMesh& unsewn, const MeasuredBody& body);

}  // namespace selvedge::sim
