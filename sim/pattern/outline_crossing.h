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

// Curves are followed to 0.1 mm. The first crossing of each pair of edges, `most` pairs at most. Pre: edges have
// length.
std::vector<OutlineCrossing> find_outline_crossings(const Panel& panel, std::size_t most);

}  // namespace selvedge
