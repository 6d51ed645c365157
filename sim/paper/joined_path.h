#pragma once
// Paths that meet end to end as one closed path.
#include <vector>

#include "sim/paper/closed_chains.h"
#include "sim/paper/drawing.h"

namespace selvedge::sim {

// Points on a path's curves, its ends among them: 16 on each curve. Pre: it is open, and has an edge.
std::vector<Vec2d> points_of_path(const DrawnPath& path);

// `paths` has one path per link. Each edge ends where the next begins, also where the ends lay apart. Kind, name and
// line are those of the first path.
DrawnPath joined_path(const std::vector<const DrawnPath*>& paths, const ClosedChain& chain);

}  // namespace selvedge::sim
