#pragma once
// The geometry of single outline edges: splitting, reversing, mapping and joining their curves; moving vertices of an
// outline with its curves, and mapping a whole panel. For editing and import.
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::sim {

struct SplitCurve {
    OutlineEdge before;
    OutlineEdge after;
    Vec2d point = Vec2d::Zero();
};

// Splits the edge at the fraction t of its length without changing its shape: Beziers by de Casteljau, arcs stay arcs.
// `vertex` is the index that the new point will have. The second part has no key.
SplitCurve split_curve(const Panel& panel, const OutlineEdge& edge, double t, int vertex);

// Splits an edge of the panel. The new vertex is its last; the second part is edge + 1, and notches stay in place.
void split_edge(Panel& panel, int edge, double t);

// The point of an edge nearest to u: the fraction t of the edge's length and the distance, m.
struct NearestOnEdge {
    double t = 0;
    double distance = 0;
};
NearestOnEdge nearest_on_edge(const Panel& panel, const OutlineEdge& edge, const Vec2d& u);

// The edge with all that it has, as a straight line.
OutlineEdge straightened(OutlineEdge edge);

// The same curve, reversed: from its end to its start.
OutlineEdge reversed_edge(const OutlineEdge& edge);

// The edge's curve under the map; the caller maps the end vertices. Pre: `panel` still has the unmapped vertices. If
// the map is not a similarity, an arc becomes a cubic.
OutlineEdge mapped_curve(const Panel& panel, const OutlineEdge& edge, const Eigen::Affine2d& map);

// The similarity (rotation, scale, translation) that maps one pair of points to another. Pre: from_a != from_b.
Eigen::Affine2d chord_map(const Vec2d& from_a, const Vec2d& from_b, const Vec2d& to_a, const Vec2d& to_b);

enum class EdgeEnd { Start, End };

// The unit tangent of the edge at its start or end, in the direction of travel.
Vec2d curve_direction(const Panel& panel, const OutlineEdge& edge, EdgeEnd at);

// Replaces a chain of edges by one edge: a line if all are lines; the original curve if they are parts of a split
// curve; else the least-squares cubic with the chain's end tangents. All but shape and end comes from the first edge.
OutlineEdge joined_curve(const Panel& panel, const std::vector<OutlineEdge>& chain);

// Applies `map` to the marked vertices of an outline. If both ends of an edge move, `map` also transforms its curve; if
// one end moves, the similarity that maps the old chord to the new one does (chord_map).
struct VertexMove {
    std::vector<bool> is_moved;  // per vertex
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
};
void move_outline(Panel& panel, const VertexMove& move);

// The panel under a map of the plane: outline, internal lines, grain, notches. Vertices keep their indices. If the map
// mirrors, edge e becomes edge (count - e) % count and is reversed, so that edge 0 stays edge 0.
Panel mapped_panel(const Panel& panel, const Eigen::Affine2d& map);

// The index of edge e after mirroring a panel of `count` edges.
inline int mirrored_edge(int e, int count) {
    return (count - e) % count;
}

// The reflection in the line through two points. Pre: from != to.
Eigen::Affine2d reflection_in(const Vec2d& from, const Vec2d& to);

// The whole of a panel that was cut on the fold: the half joined to its mirror image over a straight edge. Edges before
// the fold keep their indices; then come the images of all edges, in reverse order from the edge before the fold on;
// then the edges after the fold. Images have the keys of their edges, as EdgeRole::Image,
// or new ones where the half has images itself.
Panel unfolded(const Panel& half, int fold);

// Where edge e of a half of `count` edges and its image are in the whole. Pre: e != fold.
inline int unfolded_index(int e, int fold, int count) {
    return e < fold ? e : e + count - 2;
}
inline int unfolded_image(int e, int fold, int count) {
    return fold + (fold - 1 - e + count) % count;
}

// The panel's bounding box in its held frame (sim/pattern/pattern.h), m, curves included up to the chord error, m. The
// origin if it has no outline.
Eigen::AlignedBox2d outline_box(const Panel& panel, double chord_error = 1e-4);

}  // namespace selvedge::sim
