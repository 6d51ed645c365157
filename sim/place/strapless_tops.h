#pragma once
// Bodices without straps, which GarmentCode's programs mark by a label on their upper edges. (Korosteleva and
// Sorkine-Hornung 2023, GarmentCode: Programming Parametric Sewing Patterns)
#include "sim/pattern/pattern.h"
#include "sim/place/measured_body.h"

namespace selvedge::sim {

// Raises what seams join with such an edge until the edge's mean height is that of the armpits, above the bust that
// holds it: it is placed 10 to 15 cm lower, and the simulation of that program holds it up while it is sewn. Leaves
// what also hangs from a shoulder. Pre: placed for `body`. Returns the largest move, m.
double raise_strapless_tops(Pattern& pattern, const MeasuredBody& body);

}  // namespace selvedge::sim
