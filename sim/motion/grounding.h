#pragma once
// Puts a posed or moving body on the floor: one lift for a whole clip, so that jumps stay jumps.
#include "sim/body/body.h"
#include "sim/body/clip.h"
#include "sim/body/pose.h"

namespace selvedge::sim {

// The lowest point of the skinned surface, m; of a clip over its whole length, sampled at 30 Hz, or at 3000 times if it
// is longer than 100 s. Pre: the body has a skin.
double lowest_point(const Body& body, const Pose& pose);
double lowest_point(const Body& body, const Clip& clip);

// Moves the pose or the whole clip up or down so that its lowest point is at y = 0. Returns the lift, m; positive is
// upward. Pre: the body has a skin.
double stand_on_floor(const Body& body, Pose& pose);
double stand_on_floor(const Body& body, Clip& clip);

// Puts a clip of another skeleton on the floor: its feet are on it where they are lowest but for a tenth of the time,
// and while any part of the surface would be below, the whole body is higher, as when it lies. Pre: the body has a
// skin.
void keep_on_floor(const Body& body, Clip& clip);

// Where the hips are in that pose, m; without hips, the first bone. Pre: the body has bones.
Vec3d hips_of(const Body& body, const Pose& pose);

// The way of the hips from one pose to another, without its height, m.
Vec3d way_over_floor(const Body& body, const Pose& from, const Pose& to);

// The poses in proportion, as blend() (pose.h), and so high that the lowest joint of the feet goes evenly from its
// height in the one to that in the other: hips and knees that go over each for themselves would put the feet through
// the floor. As blend() if the feet are not known by name.
Pose blend_on_floor(const Body& body, const Pose& a, const Pose& b, double share);

// Moves a whole pose, m in our frame.
void shift(const Body& body, Pose& pose, const Vec3d& by);

}  // namespace selvedge::sim
