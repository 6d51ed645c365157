#pragma once
// Checks that a body is fit for draping: closed, manifold, without self-intersections.
#include "sim/body/body.h"

namespace selvedge::sim {

// Every directed edge occurs once, and so does its opposite; one piece without handles (V - E + F = 2).
bool is_closed_manifold(const Body& body);

double volume(const Body& body);  // m^3, positive when triangles face outward

// Number of pairs of triangles that meet elsewhere than in a shared vertex or edge. By CGAL, in exact arithmetic.
int count_self_intersections(const Body& body);

}  // namespace selvedge::sim
