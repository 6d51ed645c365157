#pragma once
// Finds where a garment is smaller than the body, so that its cloth must stretch in any drape. A horizontal plane cuts
// both: the garment's girth is the length of the cut in material coordinates, the body's girth is the tape length
// around everything that the garment encloses (girths: ISO 8559-1). Also measures the clearance between garment and
// body.
#include <optional>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/section.h"
#include "sim/core/math.h"
#include "sim/mesh/draw_mesh.h"
#include "sim/place/limbs.h"

namespace selvedge::sim {

struct FitOptions {
    double step = 0.02;              // m between levels
    double contact_offset = 0.0003;  // m, that the simulation keeps between cloth and body
    double thickness = 0.0003;       // m, half of the cloth's, which a tape on the body does not see
    double tolerance = 0.005;        // relative to the body's girth: smaller differences are ignored
    double reach = 0.05;             // m around a tight cut within which the cloth is stretched: one step plus 3 cm
    std::vector<double> strain_limits{};  // of the fabric, per panel; empty: 0
};

// A level, or a plane round a limb, at which one closed loop of the garment is shorter than a tape at the contact
// offset round what it encloses.
struct TightLevel {
    double y = 0;                    // m; of the limb's middle
    double garment_girth = 0;        // m, around the garment in material coordinates
    double limit_girth = 0;          // m, the same with each panel stretched to its fabric's limit
    double body_girth = 0;           // m, tape around the body over the cloth's thickness
    double contact_girth = 0;        // m, tape around the body at a distance of contact_offset
    Vec3d low = Vec3d::Zero();       // m, bounding box of the garment's loop in 3D
    Vec3d high = Vec3d::Zero();      // its y equals the level's
    Eigen::AlignedBox2d enclosed{};  // m, x and z of the body's sections in it
};

// Tight levels ordered by height, at multiples of the step. Each closed loop counts separately, so one level can occur
// several times: for the torso and two sleeves. A sleeve and the arm in it are cut obliquely, but by the same plane.
// One tape goes around both legs in a skirt. Open garment sections have no girth and are skipped. Pre: triangles have
// corner material coordinates and consistent orientation; positions are finite.
std::vector<TightLevel> tight_levels(const DrawMesh& garment, const Body& body, const FitOptions& options = {});

// The same round limbs that are nearly level, as arms in a T: by planes square to them, since level ones cut sleeves
// open there. In the order of the limbs. Pre: as of tight_levels(); the limbs are of that body.
std::vector<TightLevel> tight_round_level_limbs(const DrawMesh& garment, const Body& body, const BodyLimbs& limbs,
                                                const FitOptions& options = {});

// The garment's loop at a limb where cloth passes through that at a point: given if it is too small to go round the
// limb there, also with each panel stretched to its limit. Pre: as of tight_round_level_limbs().
std::optional<TightLevel> too_small_for_limb(const DrawMesh& garment, const Body& body, const BodyLimbs& limbs,
                                             const Vec3d& x, const FitOptions& options = {});

// By how much the loop is smaller than the body, m; 0 where the difference is below the tolerance. The contact offset
// does not count.
double shortfall(const TightLevel& level, const FitOptions& options = {});

// The same loop where the body is narrowest on its way, up or down, as long as that gets no wider than the tolerance:
// what is too small there fits nowhere within its reach. Pre: the sections are of the body of tight_levels().
TightLevel slid_to_narrowest(const TightLevel& level, const LevelSections& body, const FitOptions& options = {});

// The strain that tightness explains at a point: that of the tightest loop within reach, 0 where there is none. For
// example, a tight sleeve explains nothing at the waist beside it.
double explained_strain(const std::vector<TightLevel>& levels, const Vec3d& x, const FitOptions& options = {});

// Distance between garment and body.

// Signed distance from each point to the body's surface, m, negative inside. Exact up to rounding.
std::vector<float> measure_clearance(const std::vector<Vec3f>& points, const Body& body);

}  // namespace selvedge::sim
