#include "sim/paper/path_builder.h"

#include <array>
#include <cstdio>
#include <utility>

namespace selvedge::sim {

void PathBuilder::move(const Vec2d& to) {
    position_ = to;
    paths_.emplace_back();
    paths_.back().vertices.push_back(to);
}

void PathBuilder::add(OutlineEdge edge, const Vec2d& to) {
    if (paths_.empty() || paths_.back().is_closed) move(position_);
    DrawnPath& path = paths_.back();
    edge.start = static_cast<int>(path.vertices.size()) - 1;
    edge.end = edge.start + 1;
    path.vertices.push_back(to);
    path.edges.push_back(std::move(edge));
    position_ = to;
}

void PathBuilder::line(const Vec2d& to) {
    add({}, to);
}

void PathBuilder::quadratic(const Vec2d& control, const Vec2d& to) {
    OutlineEdge edge;
    edge.kind = CurveKind::Quadratic;
    edge.control[0] = control;
    add(std::move(edge), to);
}

void PathBuilder::cubic(const Vec2d& control1, const Vec2d& control2, const Vec2d& to) {
    OutlineEdge edge;
    edge.kind = CurveKind::Cubic;
    edge.control = {control1, control2};
    add(std::move(edge), to);
}

void PathBuilder::arc(double radius, bool is_large, bool turns_right, const Vec2d& to) {
    OutlineEdge edge;
    edge.kind = CurveKind::Arc;
    edge.arc_radius = radius;
    edge.is_large_arc = is_large;
    edge.turns_right = turns_right;
    add(std::move(edge), to);
}

void PathBuilder::close() {
    if (paths_.empty() || paths_.back().is_closed) return;
    const Vec2d start = paths_.back().vertices.front();
    if (position_ != start) line(start);
    paths_.back().is_closed = true;
    position_ = start;
}

namespace {

// A bound of the curve's length.
double control_length(const DrawnPath& path, const OutlineEdge& edge) {
    const Vec2d start = path.vertices[static_cast<std::size_t>(edge.start)];
    const Vec2d end = path.vertices[static_cast<std::size_t>(edge.end)];
    if (edge.kind == CurveKind::Quadratic) return (edge.control[0] - start).norm() + (end - edge.control[0]).norm();
    if (edge.kind != CurveKind::Cubic) return (end - start).norm();
    return (edge.control[0] - start).norm() + (edge.control[1] - edge.control[0]).norm() +
           (end - edge.control[1]).norm();
}

// Without short edges: the point at which one ends moves to where it began.
void drop_short(DrawnPath& path, double shortest) {
    DrawnPath kept = path;
    kept.edges.clear();
    kept.vertices = {path.vertices.front()};
    for (OutlineEdge edge : path.edges) {
        if (control_length(path, edge) <= shortest) continue;
        const Vec2d end = path.vertices[static_cast<std::size_t>(edge.end)];
        edge.start = static_cast<int>(kept.vertices.size()) - 1;
        edge.end = edge.start + 1;
        kept.vertices.push_back(end);
        kept.edges.push_back(std::move(edge));
    }
    path = std::move(kept);
}

// Lets the last edge end at the first vertex.
void join_ends(DrawnPath& path) {
    path.is_closed = true;
    path.vertices.pop_back();
    path.edges.back().end = 0;
}

}  // namespace

std::vector<DrawnPath> PathBuilder::take(double shortest, double gap) {
    std::vector<DrawnPath> taken;
    for (DrawnPath& path : paths_) {
        drop_short(path, shortest);
        if (path.edges.empty()) continue;
        const double open = (path.vertices.back() - path.vertices.front()).norm();
        const bool has_area = path.edges.size() > 1 || path.edges[0].kind != CurveKind::Line;
        if (path.is_closed || (has_area && open <= gap)) {
            if (path.edges.size() < 2 && !has_area) continue;
            join_ends(path);
        }
        taken.push_back(std::move(path));
    }
    paths_.clear();
    return taken;
}

void flip(DrawnPath& path) {
    transform(path, Eigen::Affine2d(Eigen::Scaling(1.0, -1.0)));
}

void transform(DrawnPath& path, const Eigen::Affine2d& map) {
    const double scale = std::sqrt(std::abs(map.linear().determinant()));
    const bool is_mirror = map.linear().determinant() < 0;
    for (Vec2d& v : path.vertices) v = map * v;
    for (OutlineEdge& edge : path.edges) {
        for (Vec2d& control : edge.control) control = map * control;
        edge.arc_radius *= scale;
        if (is_mirror) edge.turns_right = edge.kind == CurveKind::Arc && !edge.turns_right;
    }
}

double gap_of(const DrawnPath& path) {
    return path.is_closed || path.vertices.empty() ? 0 : (path.vertices.back() - path.vertices.front()).norm();
}

std::string open_by(double gap, const std::optional<double>& metres_per_unit) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "open by %.3g %s", metres_per_unit ? 1000 * *metres_per_unit * gap : gap,
                  metres_per_unit ? "mm" : "units");
    return text.data();
}

bool nearly_closes(const DrawnPath& path) {
    constexpr double kNearly = 0.1;  // of its length
    if (path.is_closed || path.edges.size() < 2) return false;
    double length = 0;
    for (const OutlineEdge& edge : path.edges) length += control_length(path, edge);
    return path.vertices.size() > 2 && gap_of(path) < kNearly * length;
}

Panel as_panel(const DrawnPath& path) {
    Panel panel;
    panel.vertices = path.vertices;
    panel.edges = path.edges;
    return panel;
}

}  // namespace selvedge::sim
