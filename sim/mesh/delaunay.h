#pragma once
// What CGAL does for meshes: the constrained Delaunay triangulation of an outline, and on which side of a line a point
// lies, exactly.
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

// 1 if c is to the left of the line ab, -1 if to the right, 0 if on it; exact.
int side_of(const Vec2d& a, const Vec2d& b, const Vec2d& c);

// Constrained Delaunay triangulation of the inside of an outline (CGAL's Constrained_Delaunay_triangulation_2).
// Vertices 0..outline.size()-1 are the outline, counter-clockwise; the interior vertices follow. No vertex is added.
// The outline may touch itself where points coincide exactly, for example along a slit. CGAL has one point there, but
// the result keeps separate vertices, each with the triangles on its side of the slit. Each triangle starts with its
// lowest vertex and triangles are sorted, so that the result does not depend on CGAL's order. Returns nullopt if the
// outline has no inside on its left, if the inside is pinched in a point, or if an interior point is on the outline or
// coincides with another point. Pre: find_crossing(outline) is empty.
std::optional<std::vector<std::array<int, 3>>> delaunay_inside(std::span<const Vec2d> outline,
                                                               std::span<const Vec2d> interior);

}  // namespace selvedge::sim
