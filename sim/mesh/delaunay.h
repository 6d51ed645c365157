#pragma once
// Constrained Delaunay triangulation of the inside of an outline.  (CGAL's Constrained_Delaunay_triangulation_2)
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "sim/core/vec.h"

namespace selvedge {

// Triangles over the vertices 0..outline.size()-1 (the outline, counter-clockwise) and those that follow (interior).
// No vertex is added. The outline may touch itself where points coincide exactly, as the banks of a slit do: the plane
// has one point there, the result keeps the vertices apart, each with the triangles on its own bank.
// Each triangle starts with its lowest vertex, triangles are sorted, so the result does not depend on CGAL's order.
// Nothing is returned when the outline does not bound an inside on its left, when that inside is pinched in a point, or
// when an interior point lies on the outline or coincides with another.
// Pre: find_crossing(outline) is empty.
std::optional<std::vector<std::array<int, 3>>> delaunay_inside(std::span<const Vec2d> outline,
                                                               std::span<const Vec2d> interior);

}  // namespace selvedge
