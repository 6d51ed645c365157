#pragma once
// Lengths at and across a seam, where the material coordinates of the two sides disagree.  (SPEC 3.2; thesis fig. 4.6)
#include "sim/core/vec.h"

namespace selvedge {

// One side's copy of an edge AB in its own material coordinates, m.
struct EdgeCopy {
    Vec2d a;
    Vec2d b;
};

struct SeamLengthOptions {
    double ease = 0.05;  // up to this relative difference of the sides both give way; beyond it the longer side gathers
};

// The rest length of a seam edge whose sides are left_length and right_length long, m: their average, or the shorter
// when the longer is to be gathered. Symmetric in its arguments.
double seam_rest_length(double left_length, double right_length, const SeamLengthOptions& options = {});

// The point `opposite` of the triangle that holds `from`, in the coordinates of the triangle that holds `into`, after
// rotating and moving `from` (no stretching) until it lies along `into` with the mid-points coinciding.
// Pre: neither copy has zero length; both triangles are counter-clockwise, a and b are the same vertices in both.
Vec2d unfold_across(const EdgeCopy& into, const EdgeCopy& from, const Vec2d& opposite);

}  // namespace selvedge
