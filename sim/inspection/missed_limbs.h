#pragma once
// Limbs that leave a garment through other openings than they were meant to.
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "sim/inspection/report.h"
#include "sim/inspection/worn_garment.h"
#include "sim/place/limbs.h"
#include "sim/place/openings.h"

namespace selvedge::sim {

// The openings of a garment, and the limbs that were meant to leave through each.
struct MeantOpenings {
    std::vector<Opening> openings;
    LimbPassages limbs;
    std::vector<std::size_t> parts;         // per opening: garment_parts() of its panel
    std::vector<bool> hang_from_shoulders;  // per opening: what it belongs to does, so it need not hold anything up
};

// parts: garment_parts(). without_arms: per panel, panels_without_arms().
MeantOpenings find_meant_openings(const WornGarment& placed, const std::vector<std::size_t>& parts,
                                  const std::vector<bool>& without_arms, const BodyLimbs& meant_for);

std::string list_limbs(LimbSet limbs);  // "the left arm and the right arm"

// What a tailor calls an opening for these limbs, from its place on the body for which the garment was placed.
std::string_view call_opening(LimbSet limbs, std::string_view place, bool is_of_sleeve);

// Adds the faults "limb_missed" to the report.
void validate_openings(const WornGarment& garment, const PanelVertices& panels, const MeantOpenings& meant,
                       const BodyPair& bodies, DressReport& report);

}  // namespace selvedge::sim
