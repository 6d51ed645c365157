#pragma once
// The geometry of single edges: splitting, turning round, mapping and joining their curves. For the sources of this
// room.
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::editor {

struct SplitCurve {
    sim::OutlineEdge before;
    sim::OutlineEdge after;
    Vec2d point = Vec2d::Zero();
};

// The edge in two at the fraction t of its length, exactly: Beziers by de Casteljau, arcs stay arcs. `vertex` is the
// index that the point will have.
SplitCurve split_curve(const sim::Panel& panel, const sim::OutlineEdge& edge, double t, int vertex);

// The same curve from its end to its start.
sim::OutlineEdge turned_round(const sim::OutlineEdge& edge);

// The edge as the map makes it; its ends are mapped by the caller. Pre: `panel` has its ends where they were. An arc
// becomes a cubic where the map is no similarity.
sim::OutlineEdge mapped_curve(const sim::Panel& panel, const sim::OutlineEdge& edge, const Eigen::Affine2d& map);

// The turning, scaling and moving of the plane that takes one pair of points to another. Pre: from_a != from_b.
Eigen::Affine2d chord_map(const Vec2d& from_a, const Vec2d& from_b, const Vec2d& to_a, const Vec2d& to_b);

bool is_similarity(const Eigen::Affine2d& map);

enum class EdgeEnd { Start, End };

// The unit direction in which the edge runs at its start or its end.
Vec2d curve_direction(const sim::Panel& panel, const sim::OutlineEdge& edge, EdgeEnd at);

// One edge for a chain of them: a line if all are lines, the curve that was split if they are its parts, else the cubic
// with their end tangents that follows them best. Label and start are the first's.
sim::OutlineEdge joined_curve(const sim::Panel& panel, const std::vector<sim::OutlineEdge>& chain);

// Moves vertices of an outline: where[i] is where vertex i is to be. Both ends of an edge moved: `map` takes its curve
// along; one end: the curve rides along with its chord.
struct VertexMove {
    std::vector<bool> is_moved;  // per vertex
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
};
void move_outline(sim::Panel& panel, const VertexMove& move);

// The panel under a map of the plane: outline, internal lines, grain, notches. Vertices keep their indices. Where the
// map mirrors, edge e becomes edge (count - e) % count, from its end to its start: edge 0 stays edge 0.
sim::Panel mapped_panel(const sim::Panel& panel, const Eigen::Affine2d& map);

// The index that edge e of `count` has after a mirroring.
inline int mirrored_edge(int e, int count) {
    return (count - e) % count;
}

struct Box {
    Vec2d low = Vec2d::Zero();
    Vec2d high = Vec2d::Zero();
};

// What the panel covers in its held frame, curves included.
Box outline_box(const sim::Panel& panel);

}  // namespace selvedge::editor
