#pragma once
// Edges at which more than two triangles meet, as where two parts of a body touch after their vertices were welded. The
// surface is cut along them and joined again in pairs of triangles with the solid between them, so that touching parts
// get vertices of their own. (Gueziec, Taubin, Lazarus and Horn 2001, Cutting and stitching)
#include <array>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

struct EdgeCuts {
    int edges = 0;             // that more than two triangles met at
    int dropped = 0;           // triangles left out: fins, and those that no cut could part
    Vec3d at = Vec3d::Zero();  // m, middle of one of these edges
};

// x and origin are parallel; vertices that the cuts add are appended to both. Post: at most two triangles meet at any
// edge; there may be new holes. Does nothing if that is so already. Pre: the three corners of each triangle are
// different vertices.
EdgeCuts cut_crowded_edges(std::vector<Vec3d>& x, std::vector<int>& origin, std::vector<std::array<int, 3>>& triangles);

}  // namespace selvedge::sim
