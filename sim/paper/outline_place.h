#pragma once
// The place on an outline that is nearest to a point.
#include <limits>

#include "sim/core/math.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

struct OutlinePlace {
    int edge = 0;
    double t = 0;                                               // fraction of the edge's length
    double distance = std::numeric_limits<double>::infinity();  // m
};

OutlinePlace place_on_edge(const Panel& panel, std::size_t edge, const Vec2d& p);

// At infinity for a panel without edges.
OutlinePlace nearest_place(const Panel& panel, const Vec2d& p);

}  // namespace selvedge::sim
