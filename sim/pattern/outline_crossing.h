#pragma once
// Whether an outline keeps clear of itself, and the limits that outlines and seams keep to: what loading refuses and
// what drafting must not make.
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge {

inline constexpr double kShortestEdge = 1e-5;    // m
inline constexpr std::size_t kMostEdges = 5000;  // of one panel
inline constexpr double kSmallestArea = 1e-8;    // m^2
inline constexpr double kMostGathers = 4;        // a seam side this many times its partner is a slip of the pen

// Two edges of a panel, first <= second, that cross or touch elsewhere than where neighbours join.
struct OutlineCrossing {
    std::size_t first = 0;
    std::size_t second = 0;
    Vec2d place = Vec2d::Zero();  // m, held frame
};

struct CrossingSearch {
    std::size_t most = 20;  // pairs of edges to report: a scribble need not be listed whole
    double clearance = 0;   // m, what comes this near to something else touches it
};

// Curves are followed to 0.1 mm. The first crossing of each pair of edges. Pre: edges have length.
std::vector<OutlineCrossing> find_outline_crossings(const Panel& panel, const CrossingSearch& search = {});

}  // namespace selvedge
