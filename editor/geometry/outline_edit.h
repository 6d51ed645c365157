#pragma once
// Changing the outlines of a pattern's panels. Seams, notches, pins and the other panel of a seam follow: what was sewn
// stays sewn wherever it can. Lengths in metres, points in the panel's held frame (sim/pattern/pattern.h).
//
// Every function throws GeometryError, and leaves the pattern as it was, when the outline would have no inside: fewer
// than three vertices' worth, an edge shorter than 0.01 mm, outlines that cross themselves or come nearer than 0.0001
// mm; or when a side of a seam would be over four times as long as the other. So whatever is drafted can be saved and
// loaded. Indices are checked, too.
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// The index of the panel of that name. Throws GeometryError when there is none.
int find_panel(const sim::Pattern& pattern, const std::string& name);

// Sets a vertex at the fraction t of the edge's length; the curve keeps its shape. The edges after it count one more;
// vertices keep their indices, the new one is the last. A seam there becomes two, and the other side is split where it
// meets t: the seam stays with the part at the start of this edge, the other, unnamed, is added at the end of the
// pattern's. Both parts keep the edge's label. Returns the new vertex' index.
int split_edge(sim::Pattern& pattern, sim::SeamSide at, double t);

// Takes vertices out; the edges round them become one edge: a line, if all were lines; the whole curve again, if they
// are the parts that split_edge made of it; else a cubic that keeps the end tangents. Its index is the first's. The
// seams along them become one (that of the first edge) if the edges across follow each other too and meet without a
// corner or, in the same panel, at vertices that are taken out with these: then those are joined as well. Else they go.
void remove_vertices(sim::Pattern& pattern, int panel, std::vector<int> vertices);

// Moves vertices; the curves of edges with one end moved ride along with their chord.
void move_vertices(sim::Pattern& pattern, int panel, const std::vector<int>& vertices, const Vec2d& by);

// Applies a map of the plane to some vertices and to the controls of edges between two of them.
void transform_vertices(sim::Pattern& pattern, int panel, const std::vector<int>& vertices, const Eigen::Affine2d& map);

// All of a panel: outline, internal lines, grain; its placement stays. Arcs become cubics where the map is no
// similarity: those over half a circle then lose some of their shape. A map that mirrors keeps the outline
// counter-clockwise: edge e of n becomes edge (n - e) % n, from its end to its start, so that edge 0 stays edge 0;
// vertices keep their indices; seams turn is_reversed, notches and the sett's offset follow.
void transform_panel(sim::Pattern& pattern, int panel, const Eigen::Affine2d& map);

// The edge's curve: kind, controls or arc as in `curve`; its ends and label stay.
void set_curve(sim::Pattern& pattern, sim::SeamSide at, const sim::OutlineEdge& curve);

// A point of an edge nearest to u: fraction of its length, and the distance, m.
struct NearestOnEdge {
    double t = 0;
    double distance = 0;
};
NearestOnEdge nearest_on_edge(const sim::Panel& panel, const sim::OutlineEdge& edge, const Vec2d& u);

}  // namespace selvedge::editor
