#pragma once
// Quality checks of a dressed garment: they find its faults and fill in the report's numbers.
#include <optional>
#include <span>
#include <string>

#include "sim/cloth/cloth.h"
#include "sim/cloth/cloth_penetration.h"
#include "sim/dress/drape.h"
#include "sim/dress/sewing.h"
#include "sim/inspection/report.h"
#include "sim/pattern/pattern.h"
#include "sim/place/fit.h"

namespace selvedge::sim {

class BodyCollider;

// Limits above which a value is a fault.
struct FaultLimits {
    double depth = 0.0005;          // m, depth of a vertex inside the body; of what counts as an edge or face in it
    double face_depth = kFaceDip;   // m, of an edge or face
    double stretch_p99 = 0.02;      // warp or weft strain beyond the fabric's limit and what tightness explains
    double stretch_max = 0.12;      // the same
    bool may_cross_itself = false;  // whether cloth that passes through itself is no fault
};

// Fills in mesh counts, contact, stretch, open seams, notes and faults. too_small: what fits_nowhere() found when the
// garment was sewn, for cloth that has crumpled since and does not show it.
void validate(const Cloth& cloth, const BodyCollider& body, const Pattern& pattern,
              std::span<const OpenSeam> open_seams, const DrapeResult& draped, DressReport& report,
              const FaultLimits& limits = {}, const std::optional<TightLevel>& too_small = {});

// A garment that is much too small for the body as its panels stand round it (sim/place/placed_fit.h) cannot be put on,
// and whatever is wrong with its drape follows from that: the fault is that it does not fit, the others become notes.
// No effect if nothing is wrong with its drape.
void blame_size(const TightLevel& as_placed, const BodyLimbs& limbs, DressReport& report);

// A garment whose panels reach below the floor lies in a heap round the feet: what is wrong with the heap follows from
// its length. If it is longer by at least kMuchTooLong, the fault is that it does not fit, and what is wrong below the
// knees becomes notes. No effect if nothing is. knees: their height, m.
inline constexpr double kMuchTooLong = 0.10;  // m: a hem turned up, or a short train, takes less
void blame_length(double below_floor, double knees, DressReport& report);

// Whether cloth that hangs is smaller than what it encloses of the body, though it were stretched to its limit.
bool is_too_small(const Cloth& cloth, const Body& body);

// Whether the 99th percentile of its stretch is beyond its fabrics' limits by more than stretch_p99.
bool is_overstretched(const Cloth& cloth, const FaultLimits& limits = {});

// The loop of sewn cloth that must stretch most beyond its fabric's limit though it slides to where the body is
// narrowest within its reach; none if none must by more than stretch_p99. Cloth that has crumpled does not show it.
std::optional<TightLevel> fits_nowhere(const Cloth& cloth, const Body& body, const FaultLimits& limits = {});

// How far a loop must stretch beyond its fabric's limit, relative; negative if it need not.
inline double excess_stretch(const TightLevel& level) {
    return level.body_girth / level.limit_girth - 1;
}

// Position for the user, for example "'front' beside 'left_sleeve' at x 0.123 y 1.340 z 0.051 m".
std::string describe_place(const Cloth& cloth, const Pattern& pattern, VertexId vertex);

}  // namespace selvedge::sim
