#pragma once
// Finds where a garment is smaller than the body, so that its cloth must stretch in any drape. A horizontal plane cuts
// both: the garment's girth is the length of the cut in material coordinates, the body's girth is the tape length
// around everything that the garment encloses (girths: ISO 8559-1). Also measures the clearance between garment and
// body.
#include <vector>

#include "sim/body/body.h"
#include "sim/core/math.h"
#include "sim/mesh/draw_mesh.h"

namespace selvedge::sim {

struct FitOptions {
    double step = 0.02;             // m between levels
    double contact_offset = 0.003;  // m between cloth and body
    double tolerance = 0.005;       // relative to the body's girth: smaller differences are ignored
    double reach = 0.05;            // m around a tight cut within which the cloth is stretched: one step plus 3 cm
};

// A level at which one closed loop of the garment is shorter than what it encloses.
struct TightLevel {
    double y = 0;                // m
    double garment_girth = 0;    // m, around the garment in material coordinates
    double body_girth = 0;       // m, tape around the body at a distance of contact_offset
    Vec3d low = Vec3d::Zero();   // m, bounding box of the garment's loop in 3D
    Vec3d high = Vec3d::Zero();  // its y equals the level's
};

// Tight levels ordered by height, at multiples of the step. Each closed loop counts separately, so one level can occur
// several times: for the torso and two sleeves. A sleeve and the arm in it are cut obliquely, but by the same plane.
// One tape goes around both legs in a skirt. Open garment sections have no girth and are skipped. Pre: triangles have
// corner material coordinates and consistent orientation; positions are finite.
std::vector<TightLevel> tight_levels(const DrawMesh& garment, const Body& body, const FitOptions& options = {});

// Whether the height is within reach of a tight level.
bool is_tight_at(const std::vector<TightLevel>& levels, double y, const FitOptions& options = {});

// Whether the point is within reach of a tight loop. For example, a tight sleeve does not affect the waist beside it.
bool is_tight_at(const std::vector<TightLevel>& levels, const Vec3d& x, const FitOptions& options = {});

// Distance between garment and body.

// Signed distance from each point to the body's surface, m, negative inside. Exact up to rounding.
std::vector<float> measure_clearance(const std::vector<Vec3f>& points, const Body& body);

}  // namespace selvedge::sim
