#pragma once
// What a body must be so that cloth can rest on it.
#include "sim/body/body.h"

namespace selvedge::sim {

// Every directed edge once, with its opposite once; one piece without handles (V - E + F = 2).
bool is_closed_manifold(const Body& body);

double volume(const Body& body);  // m^3, positive when triangles face outward

// Pairs of triangles that meet elsewhere than in a shared vertex or edge. By CGAL, in exact arithmetic.
int count_self_intersections(const Body& body);

}  // namespace selvedge::sim
