#pragma once
// Where a tailor measures a body, found on its surface, its centre lines and nothing else: so that a tape laid in the
// same plane of the same surface reads the same (tests/app/tape.py). Levels follow from where the body's sections join
// and part, not from shares of its stature, which no two builds have in common: legs part at the crotch, arms join the
// trunk at the armpits (ISO 8559-1:2017, 5.3).
#include <optional>
#include <vector>

#include "sim/body/section.h"
#include "sim/core/math.h"
#include "sim/place/measured_body.h"

namespace selvedge::sim {

// The sections that a tape goes round, and those beside them that it must leave out.
struct BodyGirth {
    Plane plane{};
    SectionLoop inside{};                // all points of these sections
    std::vector<Vec3d> centres{};        // m, of them
    std::vector<Vec3d> other_centres{};  // m, of the sections that are not in it

    double length() const { return tape_length(inside, plane); }  // m
};

// Each is none where the body shows no such part: legs that do not part, arms that were not found, a head without a
// neck.

// The girth of the trunk at height y, without arms and hands; of both legs below the crotch.
std::optional<BodyGirth> trunk_girth(const MeasuredBody& body, double y);

// Bust and waist: none on figures of other proportions than people's (proportions.h) whose surface does not show the
// ends of the trunk.
std::optional<BodyGirth> bust_girth(const MeasuredBody& body);   // level, the largest below the armpits
std::optional<BodyGirth> waist_girth(const MeasuredBody& body);  // level, the least: TorsoHeights::waist
std::optional<BodyGirth> hip_girth(const MeasuredBody& body);    // level, the largest above the crotch
std::optional<BodyGirth> neck_girth(const MeasuredBody& body);   // square to the neck, the least
// Square to the upper arm or the thigh, at this share of the way from its first joint to the second.
std::optional<BodyGirth> upper_limb_girth(const MeasuredBody& body, LimbKind limb, double share);
std::optional<BodyGirth> sleeve_girth(const MeasuredBody& body, LimbKind arm);  // square to the upper arm's middle

double highest_hip(const MeasuredBody& body);  // m, the upper end of the range in which hip_girth() looks

// 3 cm under the crotch, as sim/mannequin measures it: level where the leg stands, square to a thigh that leans by more
// than 30 degrees, as of a body that sits.
std::optional<BodyGirth> thigh_girth(const MeasuredBody& body, LimbKind leg);

}  // namespace selvedge::sim
