#include "sim/place/panel_cones.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {

WaistArc waist_arc(const Panel& panel) {
    WaistArc arc;
    double best = 0;
    for (const OutlineEdge& edge : panel.edges) {
        const Vec2d a = outline_point(panel, edge, 0);
        const Vec2d ab = outline_point(panel, edge, 0.5) - a, ac = outline_point(panel, edge, 1) - a;
        const double area = cross2(ab, ac), length = outline_length(panel, edge);
        if (area > -0.02 * length * length || -area / length < best) continue;  // not hollow
        best = -area / length;
        const Vec2d off(ac.y() * ab.squaredNorm() - ab.y() * ac.squaredNorm(),
                        ab.x() * ac.squaredNorm() - ac.x() * ab.squaredNorm());
        arc.centre = a + off / (2 * area);
        arc.radius = off.norm() / (2 * -area);
    }
    constexpr double kOnCircle = 0.02;
    for (const OutlineEdge& edge : panel.edges) {
        const double distance = (outline_point(panel, edge, 0.3) - arc.centre).norm();
        if (best > 0 && std::abs(distance - arc.radius) < kOnCircle * arc.radius)
            arc.angle += outline_length(panel, edge) / arc.radius;
    }
    return arc;
}

std::optional<WrapCone> tapering_cone(const Panel& panel, int edge, int other_edge) {
    constexpr double kLeastAngle = 0.06, kMostAngle = 1;  // rad, between the edges: less is a cylinder
    const auto ends = [&](int index) {
        const OutlineEdge& own = panel.edges[static_cast<std::size_t>(index)];
        const Vec2d a = outline_point(panel, own, 0), b = outline_point(panel, own, 1);
        return a.y() < b.y() ? std::pair(a, b) : std::pair(b, a);
    };
    const auto [low_a, high_a] = ends(edge);
    const auto [low_b, high_b] = ends(other_edge);
    const Vec2d a = high_a - low_a, b = high_b - low_b;
    const double cross = cross2(a, b), angle = std::abs(std::atan2(cross, a.dot(b)));
    const bool narrows = std::abs(high_a.x() - high_b.x()) > std::abs(low_a.x() - low_b.x());
    if (!narrows || angle < kLeastAngle || angle > kMostAngle) return std::nullopt;
    const double t = cross2(low_b - low_a, b) / cross;
    return WrapCone{.apex = low_a + t * a, .sine = -angle / (2 * std::numbers::pi)};
}

}  // namespace selvedge::sim
