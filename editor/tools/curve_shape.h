#pragma once
// Bending an edge by a point of it.
#include "editor/tools/sheet_geometry.h"

namespace selvedge {

// The curve with its handles moved so that the point at the fraction t of its length comes to `to` (held frame, m). A
// line becomes a quadratic; an arc stays one. Near the ends the handles would fly off: t counts from 0.1 to 0.9.
OutlineEdge bent_through(const Panel& panel, const OutlineEdge& edge, double t, const Vec2d& to);

// A circular arc from end to end through the point; a line where they are in line.
OutlineEdge arc_through(const Panel& panel, const OutlineEdge& edge, const Vec2d& to);

// A quadratic or cubic of the same shape as a line or quadratic: handles to take hold of.
OutlineEdge as_cubic_edge(const Panel& panel, const OutlineEdge& edge);

}  // namespace selvedge
