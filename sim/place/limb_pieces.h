#pragma once
// Arms that are in the way of a garment: the body with its arms cut off below the shoulders, and the panels that would
// close round an arm although they do not belong to it.
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "sim/body/body.h"
#include "sim/collide/jointed_collider.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/pattern.h"
#include "sim/place/limbs.h"

namespace selvedge::sim {

inline constexpr std::array<LimbKind, 2> kArms{LimbKind::LeftArm, LimbKind::RightArm};

struct BodyWithoutArms {
    Body trunk;  // closed where the arms were
    std::array<BodyPiece, kArms.size()> arms;
};

// Cuts both arms off as near to the shoulder as a plane across the upper arm cuts nothing else. nullopt if an arm was
// not found, or touches the rest of the body, so that it cannot be told from it.
std::optional<BodyWithoutArms> cut_off_arms(const Body& body, const BodyLimbs& limbs);

// The arm to which more than that share of the points are nearest.
std::optional<LimbKind> arm_nearest_to(const std::vector<Vec3d>& points, const BodyLimbs& limbs, double share);

// The arm round which a panel is placed, from GarmentCode's label and the panel's points: the one that is nearest to
// most of them. A quarter of a wide skirt also has points that are nearest to an arm, but many others.
std::optional<LimbKind> arm_of_panel(std::string_view label, const std::vector<Vec3d>& points, const BodyLimbs& limbs);

// Whether the panels ignore the arms while they are sewn, per panel. They are those through which an arm would pass if
// all seams closed where they stand, as wide skirts whose front and back stand before and behind the hands; and with
// them all others that are labelled "leg", or are placed neither over the chest nor round an arm. None if no arm passes
// through a panel.
std::vector<bool> panels_without_arms(const GarmentMesh& unsewn, const Pattern& pattern, const BodyLimbs& limbs);

}  // namespace selvedge::sim
