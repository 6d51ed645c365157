#pragma once
// The mannequin with its arms turned about the shoulders, or its legs about the hips, by its skin weights.
#include "sim/body/body.h"

namespace selvedge::sim::shapes {

// Arms straight out to the sides. Without bones and skin, as a body from a file. Pre: the body is a mannequin.
Body in_t_pose(const Body& mannequin);

// Thighs nearly level, to the front, with straight knees. The joints of its bones follow. Pre: the body is a mannequin.
Body in_seat(const Body& mannequin);

}  // namespace selvedge::sim::shapes
