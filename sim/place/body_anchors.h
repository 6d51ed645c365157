#pragma once
// Where on a body panels are placed: heights and depths of the trunk, and its sections.
#include <span>

#include "sim/body/body.h"
#include "sim/body/landmarks.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// Heights and depths of the body at which panels are placed, m.
struct Anchors {
    double shoulder = 0;  // of the neck's side, where a shoulder seam begins
    double waist = 0;
    double hip = 0;
    double crotch = 0;
    Vec3d centre = Vec3d::Zero();  // of the trunk at the waist
    double front = 0, back = 0;    // z of the trunk's outermost points
};

// Pre: the body has triangles.
Anchors anchors_of(const Body& body, const Stature& stature);

// The trunk's section at a height.
struct TrunkSection {
    Vec3d centre = Vec3d::Zero();
    double reach = 0;  // m, from there to the outermost point
    double girth = 0;  // m, by the tape
};

TrunkSection trunk_section(const Body& body, double y, double stature);

// Where a band of that length (m) rests, m: not above the waist, not below the hip.
double resting_height(const Body& body, const Anchors& anchors, const Stature& stature, double length);

// How far up a placed panel of the trunk goes, m, so that those of its edges that are shoulders, level upper ones, pass
// over the shoulders of the body.
double lift_over_shoulders(const Body& body, const Anchors& anchors, const Panel& panel, std::span<const int> edges);

}  // namespace selvedge::sim
