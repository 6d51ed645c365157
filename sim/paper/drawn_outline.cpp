#include "sim/paper/drawn_outline.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/core/math.h"
#include "sim/paper/closed_chains.h"
#include "sim/paper/joined_path.h"
#include "sim/paper/path_builder.h"
#include "sim/paper/polyline_outline.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/field_moves.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/polyline.h"

namespace selvedge::sim {
namespace {

// Of a piece that was mirrored: what is to the left of an edge stays on the side of the cloth.
Panel reversed_outline(const Panel& panel) {
    Panel reversed = panel;
    std::ranges::reverse(reversed.edges);
    for (OutlineEdge& edge : reversed.edges) {
        edge = reversed_edge(edge);
        move_fields(edge, {.map = Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0))});
    }
    return reversed;
}

// Whether a closed polygon is a curve that was drawn as lines: most of its corners are slight turns.
bool has_facets(const std::vector<Vec2d>& corners) {
    constexpr std::size_t kLeast = 24;
    constexpr double kStraight = 1e-4, kSlight = 0.25;  // rad
    std::size_t slight = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2d& at = corners[i];
        const Vec2d in = at - corners[(i + corners.size() - 1) % corners.size()];
        const Vec2d out = corners[(i + 1) % corners.size()] - at;
        const double turn = std::abs(std::atan2(cross2(in, out), in.dot(out)));
        slight += turn > kStraight && turn < kSlight ? 1 : 0;
    }
    return corners.size() >= kLeast && 2 * slight > corners.size();
}

// A closed path, m: curves that a program drew as many lines are curves again.
DrawnPath without_facets(const DrawnPath& path) {
    constexpr double kTolerance = 1e-4;  // m
    std::vector<Vec2d> corners;
    for (const OutlineEdge& edge : path.edges) {
        if (edge.kind != CurveKind::Line) return path;
        corners.push_back(path.vertices[as_size(edge.start)]);
    }
    return has_facets(corners) ? outline_of_points(corners, true, {.tolerance = kTolerance}) : path;
}

}  // namespace

void drop_short_edges(Panel& panel) {
    std::vector<OutlineEdge> kept;
    for (const OutlineEdge& edge : panel.edges) {
        if (outline_length(panel, edge) >= kShortestEdge) {
            kept.push_back(edge);
        } else if (!kept.empty()) {
            kept.back().end = edge.end;
        }
    }
    for (std::size_t e = 0; e < kept.size(); ++e) kept[e].end = kept[(e + 1) % kept.size()].start;
    panel.edges = std::move(kept);
}

void drop_unused_vertices(Panel& panel) {
    std::vector<int> image(panel.vertices.size(), -1);
    std::vector<Vec2d> kept;
    for (OutlineEdge& edge : panel.edges) {
        image[as_size(edge.start)] = static_cast<int>(kept.size());
        kept.push_back(panel.vertices[as_size(edge.start)]);
    }
    for (OutlineEdge& edge : panel.edges) {
        edge.start = image[as_size(edge.start)];
        edge.end = image[as_size(edge.end)];
    }
    panel.vertices = std::move(kept);
}

Panel outline_of(const DrawnPath& drawn) {
    Panel panel = as_panel(without_facets(drawn));
    drop_short_edges(panel);
    if (panel.edges.size() < 2) return panel;
    if (outline_area(panel) < 0) panel = reversed_outline(panel);
    drop_unused_vertices(panel);
    return panel;
}

std::optional<JoinedOutline> joined_outline(const std::vector<DrawnPath>& paths, double gap) {
    constexpr double kLeastSize = 0.8;  // of the part's
    std::vector<std::size_t> open;
    std::vector<std::vector<Vec2d>> lines;
    Eigen::AlignedBox2d part;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const DrawnPath& path = paths[i];
        if (path.edges.empty()) continue;
        if (path.kind == LineKind::Cut || path.kind == LineKind::Internal || path.kind == LineKind::Unknown)
            part.extend(box_around(path.vertices));
        if (path.kind != LineKind::Internal || path.is_closed) continue;
        open.push_back(i);
        lines.push_back(points_of_path(path));
    }
    if (open.size() < 2) return std::nullopt;
    const ClosedChains found = find_closed_chains(lines, {.gap = gap});
    if (found.chains.empty()) return std::nullopt;
    JoinedOutline joined;
    std::vector<const DrawnPath*> members;
    for (const ChainLink& link : found.chains.front()) {
        joined.used.push_back(open[link.line]);
        members.push_back(&paths[joined.used.back()]);
    }
    joined.outline = joined_path(members, found.chains.front());
    joined.outline.kind = LineKind::Sew;
    if (box_around(joined.outline.vertices).diagonal().norm() < kLeastSize * part.diagonal().norm())
        return std::nullopt;
    return joined;
}

}  // namespace selvedge::sim
