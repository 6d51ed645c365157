#pragma once
// The base mesh of a pattern with as many triangles as the thesis' garment had: 316 of the T-shirt, 488 of the dress.
#include "sim/pattern/pattern.h"

namespace selvedge::bench {

// The edge length, m, that gives the number of triangles nearest to `triangles`. Tries lengths from 0.85 to 1.15 times
// the pattern's own (5 cm if it names none), from its own outward, until the number differs by at most `tolerance`: it
// varies by some per cent from one length to the next.
double edge_length_for(const sim::Pattern& pattern, int triangles, int tolerance = 0);

}  // namespace selvedge::bench
