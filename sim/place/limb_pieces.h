#pragma once
// Limbs that are in the way of a garment: the body with limbs cut off near the torso, limbs that are thinner than the
// body has them, and the panels that would close round an arm although they do not belong to it.
#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "sim/body/body.h"
#include "sim/collide/jointed_collider.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/pattern.h"
#include "sim/place/limbs.h"

namespace selvedge::sim {

inline constexpr std::array<LimbKind, 2> kArms{LimbKind::LeftArm, LimbKind::RightArm};
inline constexpr std::array<LimbKind, 2> kLegs{LimbKind::LeftLeg, LimbKind::RightLeg};

struct LimbPiece {
    LimbKind kind = LimbKind::LeftArm;
    BodyPiece piece;               // its joint is the middle of the cut
    Vec3d along = Vec3d::UnitX();  // unit, across the cut, towards the limb's end
    double radius = 0;             // m, of the cut
};

struct BodyInPieces {
    Body trunk;                    // closed where the limbs were
    std::vector<LimbPiece> limbs;  // in the order asked for
};

// Cuts arms or legs off as near to the torso as a plane across the upper arm or the thigh cuts nothing else. Limbs that
// were not found, or that touch the rest of the body, so that they cannot be told from it, stay with the trunk.
BodyInPieces cut_off(const Body& body, const BodyLimbs& limbs, std::span<const LimbKind> kinds);

// The way along which a limb would leave a garment with the smallest turn, m: from its root through the middle of the
// cloth round it alone to the middle of an opening on its side of the body, or in the middle. `closed`: the panels
// where they stand, with all seams closed. Along the limb as it is if each opening would need a turn of more than 45
// degrees.
std::vector<Vec3d> way_out(const GarmentMesh& closed, const LimbPiece& limb, const BodyLimbs& limbs);

// The limb with all but its root bent to lie along that way, and straight on beyond its end; as long that the wrist or
// the ankle lies at the end of a way that is longer than the limb, as out of a sleeve that is too long, whose cuff
// comes back with the hand; and drawn in towards its centre line to `share` of the distance from it. Vertices keep
// their order.
Body bend_limb(const LimbPiece& limb, const BodyLimbs& limbs, const std::vector<Vec3d>& way, double share);

// The arm to which more than that share of the points are nearest.
std::optional<LimbKind> arm_nearest_to(const std::vector<Vec3d>& points, const BodyLimbs& limbs, double share);

// The arm round which a panel is placed, from GarmentCode's label and the panel's points: the one that is nearest to
// most of them. A quarter of a wide skirt also has points that are nearest to an arm, but many others.
std::optional<LimbKind> arm_of_panel(std::string_view label, const std::vector<Vec3d>& points, const BodyLimbs& limbs);

// By index, whether a link belongs to a seam that makes a tube of the panels round one of these limbs: both its panels
// are placed round that limb, and it runs along it.
std::vector<bool> links_along_limbs(const GarmentMesh& unsewn, const BodyLimbs& limbs, std::span<const LimbKind> kinds);

// The panels that no arm belongs in, per panel: those that are labelled "leg", or are placed not round an arm, and not
// over the chest, unless nothing that they are sewn to reaches up to the shoulders: a bodice without straps. Not panels
// without triangles in the mesh, as those that are worn already.
std::vector<bool> panels_without_arms(const GarmentMesh& unsewn, const Pattern& pattern, const BodyLimbs& limbs);

// Whether an arm would pass through one of these panels if all seams closed where they stand, as through a wide skirt
// whose front and back stand before and behind the hands.
bool are_in_way_of_arms(const std::vector<bool>& panels, const GarmentMesh& unsewn, const BodyLimbs& limbs);

}  // namespace selvedge::sim
