#pragma once
// What the outlines of a panel have in common in two states of it, by the keys of their edges
// (sim/pattern/edge_keys.h): stretches between points that both have. Within a stretch, places at the same fraction of
// its length correspond, so that a point that was added or removed moves nothing.
#include <utility>
#include <vector>

#include "sim/core/math.h"
#include "sim/pattern/edge_keys.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// A part of a stretch, between two fractions of its length in the outline's direction.
struct StretchPiece {
    int stretch = 0;
    double from = 0;
    double to = 1;
};

class OutlineMatch {
 public:
    // All edges have lengths that are not zero. Keeps no reference to the panels.
    OutlineMatch(const Panel& before, const Panel& after);

    // No edge is in both, they have another order, or one of the panels has no keys and another number of edges.
    bool is_empty() const { return stretches_.empty(); }

    // Where an edge lies. Pre: not empty.
    StretchPiece piece_before(int edge) const { return before_[as_size(edge)]; }
    StretchPiece piece_after(int edge) const { return after_[as_size(edge)]; }

    // Corresponding points of both outlines, m, once round: the corners of both, and `count` - 1 points between two
    // that follow each other.
    std::vector<std::pair<Vec2d, Vec2d>> points(const Panel& before, const Panel& after, int count) const;

 private:
    std::vector<OutlineStretch> stretches_;
    std::vector<StretchPiece> before_;  // per edge
    std::vector<StretchPiece> after_;
};

}  // namespace selvedge::sim
