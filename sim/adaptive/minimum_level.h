#pragma once
// Regions that are never coarser than a level: what an editor paints with a round brush.  (SPEC 1.3)
#include <cstdint>
#include <span>

#include "sim/adaptive/adaptive_mesh.h"
#include "sim/core/vec.h"

namespace selvedge {

// One dab of the brush.
struct MinimumLevelDisc {
    std::uint16_t panel = 0;
    Vec2f centre = Vec2f::Zero();  // material coordinates, m
    float radius = 0;              // m
    int level = 0;
};

// Asks for splits until every leaf that touches a disc has its level, and lets none of them rejoin below it. An edge
// also asks for discs within its triangle's size: a neighbour that stays coarse would keep the disc's border coarse
// (permissions, SPEC 1.2). A disc ends at its panel's seams; paint both sides where the seam itself must be fine.
struct MinimumLevelCriterion {
    std::span<const MinimumLevelDisc> discs;

    bool wants_split(const AdaptiveMesh& mesh, EdgeId e) const { return is_above(mesh, e); }
    bool allows_rejoin(const AdaptiveMesh& mesh, EdgeId e) const { return !is_above(mesh, e); }

 private:
    bool is_above(const AdaptiveMesh& mesh, EdgeId e) const;
};

// From a point to a triangle in the plane, m; 0 inside. Pre: anticlockwise.
float distance_to_triangle(const Vec2f& p, const std::array<Vec2f, 3>& triangle);

}  // namespace selvedge
