#pragma once
// A panel with straight edges, for tests of several modules.
#include <utility>
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// Counter-clockwise corners, m; edge i begins at corner i.
inline Panel polygon(const char* name, std::vector<Vec2d> corners) {
    Panel panel;
    panel.name = name;
    panel.vertices = std::move(corners);
    const int count = static_cast<int>(panel.vertices.size());
    for (int i = 0; i < count; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % count});
    return panel;
}

}  // namespace selvedge::sim
