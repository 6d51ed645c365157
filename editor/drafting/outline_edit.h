#pragma once
// Changing the outlines of a pattern's panels. Seams, notches, pins and the other panel of a seam follow: what was sewn
// stays sewn wherever it can. Lengths in metres, points in the panel's held frame (sim/pattern/pattern.h).
//
// Every function throws DraftError, and leaves the pattern as it was, when the outline would have no inside: fewer than
// three vertices' worth, an edge shorter than 0.01 mm, outlines that cross themselves. Indices are checked, too.
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge {

// The index of the panel of that name. Throws DraftError when there is none.
int find_panel(const Pattern& pattern, const std::string& name);

// Sets a vertex at the fraction t of the edge's length; the curve keeps its shape. The edges after it count one more. A
// seam there becomes two, and the other side is split where it meets t. Returns the new vertex' index.
int split_edge(Pattern& pattern, SeamSide at, double t);

// Takes vertices out; each edge pair becomes one edge: a line, if both were lines, else a cubic that keeps the end
// tangents. Seams along them go, unless both sides' vertices that meet were removed.
void remove_vertices(Pattern& pattern, int panel, std::vector<int> vertices);

// Moves vertices; the curves of edges with one end moved ride along with their chord.
void move_vertices(Pattern& pattern, int panel, const std::vector<int>& vertices, const Vec2d& by);

// Applies a map of the plane to some vertices and to the controls of edges between two of them.
void transform_vertices(Pattern& pattern, int panel, const std::vector<int>& vertices, const Eigen::Affine2d& map);

// All of a panel: outline, internal lines; arcs become what they are mapped to, cubics where the map is no similarity.
// A map that mirrors keeps the outline counter-clockwise: edges then run the other way round, seams follow.
void transform_panel(Pattern& pattern, int panel, const Eigen::Affine2d& map);

// The edge's curve: kind, controls or arc as in `curve`; its ends and label stay.
void set_curve(Pattern& pattern, SeamSide at, const OutlineEdge& curve);

// A point of an edge nearest to u: fraction of its length, and the distance, m.
struct NearestOnEdge {
    double t = 0;
    double distance = 0;
};
NearestOnEdge nearest_on_edge(const Panel& panel, const OutlineEdge& edge, const Vec2d& u);

}  // namespace selvedge
