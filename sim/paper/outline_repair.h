#pragma once
// Mends small faults of drawn outlines, before panels are made of them: lines drawn forth and back, slits without
// width, and small loops where the outline crosses itself.
#include <optional>

#include "sim/pattern/pattern.h"

namespace selvedge::sim {

struct OutlineRepairs {
    int retraced = 0;             // lines that ran back over their neighbour, and were taken off
    int slits = 0;                // that were opened by a hair
    int loops = 0;                // that were cut off
    double longest_loop = 0;      // m
    Vec2d place = Vec2d::Zero();  // of it, m

    bool is_any() const { return retraced + slits + loops > 0; }
};

// What cannot be mended, as a crossing whose loop is a large part of the outline, stays as it is.
// Pre: the edges are a closed outline, each from the end of the one before, counter-clockwise.
OutlineRepairs repair_outline(Panel& panel);

}  // namespace selvedge::sim
