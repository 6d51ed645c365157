#pragma once
// What the outlines and seams of the panels of a sleeve tell of how they lie round the arm.
#include <cstddef>

#include "sim/pattern/pattern.h"
#include "sim/place/panel_flanks.h"

namespace selvedge::sim {

// From the underarm of a sleeve of one panel up to the top of its cap, m; 0: no seam of its own closes it.
double cap_height(const Pattern& pattern, const SewnEdges& sewn, std::size_t p);

// How much higher the middle of panel p lies than that of `other` when the seams between both are level, m.
double level_between(const Pattern& pattern, const SewnEdges& sewn, std::size_t p, std::size_t other);

// Whether two halves of a sleeve meet over the shoulder, each with its top at that seam; otherwise one is the upper
// sleeve, whose top lies in its middle. Pre: both are drawn upright.
bool are_front_and_back(const Panel& half, const Panel& other);

}  // namespace selvedge::sim
