#pragma once
// Edits the outlines of a pattern's panels. Seams, notches, pins and the other side of a seam are updated: sewn edges
// stay sewn where possible. Lengths in metres, points in the panel's held frame (sim/pattern/pattern.h).
//
// Every function throws GeometryError, and leaves the pattern unchanged, if an index is out of range or if the result
// would be invalid: an outline with an area below 1e-8 m^2, with an edge shorter than 0.01 mm, that crosses itself or
// comes within 0.0001 mm of itself, or that lies further than 100 m from the origin; or a seam with one side over four
// times as long as the other. So every result can be saved and loaded again.
#include <optional>
#include <string>
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// The index of the panel with this name. None: there is no such panel; find_panel then throws GeometryError.
std::optional<int> panel_index(const sim::Pattern& pattern, const std::string& name);
int find_panel(const sim::Pattern& pattern, const std::string& name);

// Inserts a vertex at the fraction t of the edge's length; the curve keeps its shape. Indices of later edges grow by
// one; vertices keep their indices, and the new vertex is the last. If the edge is sewn, its seam becomes two: the
// other side is split at the point that meets t, the seam stays with the first part of this edge, and a new, unnamed
// seam is appended to the pattern. Both parts keep the edge's label. Returns the index of the new vertex.
int split_edge(sim::Pattern& pattern, sim::SeamSide at, double t);

// Removes vertices. The edges around each run of removed vertices become one edge, with the index of the first: a line,
// if all were lines; the original curve, if they are its parts after split_edge; else a cubic with the same end
// tangents. Their seams become one (that of the first edge) if the edges on the other side are consecutive too and
// meet without a corner or, in the same panel, at vertices that are also removed: then those edges are joined as well.
// Otherwise these seams are removed.
void remove_vertices(sim::Pattern& pattern, int panel, std::vector<int> vertices);

// Moves vertices. If only one end of an edge moves, its curve is transformed with its chord.
void move_vertices(sim::Pattern& pattern, int panel, const std::vector<int>& vertices, const Vec2d& by);

// Applies a map of the plane to some vertices and to the control points of edges between two of them. If only one end
// of an edge moves, its curve is transformed with its chord.
void transform_vertices(sim::Pattern& pattern, int panel, const std::vector<int>& vertices, const Eigen::Affine2d& map);

// Applies a map to a whole panel: outline, internal lines, grain; its 3D placement stays. If the map is not a
// similarity, arcs become cubics; arcs over half a circle are then only approximated. A mirroring map keeps the outline
// counter-clockwise: edge e of n becomes edge (n - e) % n and is reversed, so that edge 0 stays edge 0. Vertices keep
// their indices; Seam::is_reversed is toggled; notches and the sett offset are updated.
void transform_panel(sim::Pattern& pattern, int panel, const Eigen::Affine2d& map);

// Sets the edge's kind and its control points or arc from `curve`; its ends and label stay.
void set_curve(sim::Pattern& pattern, sim::SeamSide at, const sim::OutlineEdge& curve);

}  // namespace selvedge::editor
