#include "editor/tools/curve_shape.h"

#include <algorithm>
#include <cmath>

#include "sim/pattern/outline.h"

namespace selvedge {
namespace {

struct Ends {
    Vec2d start;
    Vec2d end;
};

Ends ends_of(const Panel& panel, const OutlineEdge& edge) {
    return {panel.vertices.at(static_cast<std::size_t>(edge.start)),
            panel.vertices.at(static_cast<std::size_t>(edge.end))};
}

// The curve's own parameter where the fraction t of its length is reached, by halving.
double parameter_at(const Panel& panel, const OutlineEdge& edge, double t) {
    if (edge.kind == CurveKind::Line) return t;
    const Vec2d wanted = outline_point(panel, edge, t);
    double best = t, distance = (curve_point(panel, edge, t) - wanted).norm();
    for (double step = 0.25; step > 1e-4; step /= 2) {
        for (const double s : {best - step, best + step}) {
            const double away = (curve_point(panel, edge, std::clamp(s, 0.0, 1.0)) - wanted).norm();
            if (away < distance) {
                distance = away;
                best = std::clamp(s, 0.0, 1.0);
            }
        }
    }
    return best;
}

}  // namespace

OutlineEdge bent_through(const Panel& panel, const OutlineEdge& edge, double t, const Vec2d& to) {
    if (edge.kind == CurveKind::Arc) return arc_through(panel, edge, to);
    const auto [start, end] = ends_of(panel, edge);
    const double s = std::clamp(parameter_at(panel, edge, t), 0.1, 0.9);
    const double r = 1 - s;
    OutlineEdge bent = edge;
    if (edge.kind == CurveKind::Cubic) {
        const Vec2d by = (to - curve_point(panel, edge, s)) / (3 * r * s);
        bent.control[0] += by;
        bent.control[1] += by;
        return bent;
    }
    bent.kind = CurveKind::Quadratic;
    bent.control[0] = (to - r * r * start - s * s * end) / (2 * r * s);
    return bent;
}

OutlineEdge arc_through(const Panel& panel, const OutlineEdge& edge, const Vec2d& to) {
    const auto [start, end] = ends_of(panel, edge);
    const Vec2d chord = end - start, a = to - start, b = to - end;
    const double twice_area = cross2(chord, a);  // positive: the point lies to the left
    OutlineEdge arc = edge;
    arc.control = {Vec2d::Zero(), Vec2d::Zero()};
    if (std::abs(twice_area) <= 1e-4 * chord.squaredNorm()) {
        arc.kind = CurveKind::Line;
        arc.arc_radius = 0;
        return arc;
    }
    arc.kind = CurveKind::Arc;
    arc.arc_radius = a.norm() * b.norm() * chord.norm() / (2 * std::abs(twice_area));
    arc.turns_right = twice_area > 0;
    arc.is_large_arc = a.dot(b) > 0;  // the point sees the chord under less than a right angle
    return arc;
}

OutlineEdge as_cubic_edge(const Panel& panel, const OutlineEdge& edge) {
    const auto [start, end] = ends_of(panel, edge);
    OutlineEdge cubic = edge;
    if (edge.kind == CurveKind::Cubic) return cubic;
    cubic.kind = CurveKind::Cubic;
    if (edge.kind == CurveKind::Quadratic) {
        cubic.control = {start + 2.0 / 3 * (edge.control[0] - start), end + 2.0 / 3 * (edge.control[0] - end)};
    } else {
        cubic.control = {start + (end - start) / 3, end - (end - start) / 3};
    }
    return cubic;
}

}  // namespace selvedge
