#pragma once
// The limbs of a body as centre lines with sections: torso, head, arms and legs, in any pose of the arms. The lines
// follow the skeleton where the body has one with the names of sim/mannequin; otherwise they are found on the surface:
// torso and legs by horizontal sections, arms by curves of equal geodesic distance from the fingertips (Verroust and
// Lazarus 2000, Extracting skeletal curves from 3D scattered data).
#include <array>
#include <bitset>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/landmarks.h"
#include "sim/body/section.h"
#include "sim/core/math.h"

namespace selvedge::sim {

enum class LimbKind { Head, LeftArm, RightArm, LeftLeg, RightLeg };
inline constexpr std::size_t kLimbCount = 5;
using LimbSet = std::bitset<kLimbCount>;  // by LimbKind

constexpr std::size_t index_of(LimbKind kind) {
    return static_cast<std::size_t>(kind);
}

std::string_view name_of(LimbKind kind);  // "left arm"

// A joint of a centre line.
struct LimbJoint {
    Vec3d centre = Vec3d::Zero();  // m
    double radius = 0;             // m, of the circle with the area of the section halfway to the next joint
};

// A limb from the torso to its end. Joints of an arm: shoulder, elbow, wrist, fingertips; of a leg: hip, knee, ankle,
// sole; of the head: neck, middle, top.
struct Limb {
    bool is_found = false;
    std::vector<LimbJoint> joints;  // empty if it was not found
    std::vector<Vec3d> line;        // m, through its middle, from the first joint, or near it, to the last
};

struct BodyLimbs {
    std::vector<LimbJoint> torso;  // hips, waist, chest, neck; empty if the body has no sections there
    std::array<Limb, kLimbCount> limbs;
    HeightRange height;  // m, of the body

    const Limb& operator[](LimbKind kind) const { return limbs[index_of(kind)]; }
    LimbSet found() const;
};

// A limb that was not found has no joints.
BodyLimbs find_limbs(const Body& body);
BodyLimbs find_limbs(const Body& body, const Stature& stature);  // find_stature(body)

// The centre line to a limb's end: from the hips through the torso, then along the limb. Pre: the limb was found.
std::vector<Vec3d> line_to_end(const BodyLimbs& limbs, LimbKind kind);

// Where the straight line from one joint to the next is nearest to a point, as a share of it, 0..1.
double nearest_share(const LimbJoint& from, const LimbJoint& to, const Vec3d& x);

// The place on a centre line whose section, taken for round, is nearest to a point.
struct LimbPosition {
    std::optional<LimbKind> limb;  // none: the torso
    std::size_t joint = 0;         // the nearest point lies between this joint and the next
    double share = 0;              // of the way to the next joint, 0..1
};
std::optional<LimbPosition> nearest_on_limbs(const BodyLimbs& limbs, const Vec3d& x);

// "left ankle", "waist"; empty if no limb was found.
std::string place_on_body(const BodyLimbs& limbs, const Vec3d& x);

// Levels and sections of the torso, also where the limbs are not needed.

struct TorsoHeights {
    double neck = 0;  // m, as all others
    double chest = 0;
    double waist = 0;  // of the smallest girth
    double hip = 0;
};
TorsoHeights torso_heights(const Body& body, const Stature& stature);

// Of the sections of a body of that stature (m) at one height, whether each is of the trunk or of both legs. Arms and
// hands are not: they are thin or far from the centre.
std::vector<bool> are_of_trunk(const std::vector<SectionLoop>& sections, double stature);

// The points of those at height y (m).
std::vector<Vec3d> trunk_points(const Body& body, double y, double stature);

// The centre of the bounding box of section points, m.
Vec3d middle_of_box(const std::vector<Vec3d>& points);

}  // namespace selvedge::sim
