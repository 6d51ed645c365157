#pragma once
// The edge over which a half is unfolded whose drawing only says "cut on fold".
#include <optional>
#include <vector>

#include "sim/paper/drawing.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

struct FoldEdge {
    std::optional<int> edge = {};  // none: no edge is surely the fold
    bool is_any = false;           // some edge could be
};

// A fold is straight, runs along the grain, and meets its neighbours at right angles, so that the whole goes on
// smoothly across it; unfolded, the panel does not cross itself. It is sure where a text that says "fold" stands beside
// it, or where it is a quarter longer than the next edge that could be one. panel: outline in m, with its grain angle.
// texts: with their places in m.
FoldEdge find_fold_edge(const Panel& panel, const std::vector<DrawnText>& texts);

}  // namespace selvedge::sim
