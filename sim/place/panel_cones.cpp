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

std::optional<WrapCone> tapering_cone(const Panel& panel, const std::vector<int>& side,
                                      const std::vector<int>& other_side) {
    constexpr double kLeastAngle = 0.06, kMostAngle = 1;  // rad, between the edges: less is a cylinder
    const auto ends = [&](const std::vector<int>& edges) {
        std::vector<Vec2d> points;
        for (const int index : edges) {
            const OutlineEdge& own = panel.edges[static_cast<std::size_t>(index)];
            for (const double t : {0.0, 1.0}) points.push_back(outline_point(panel, own, t));
        }
        const auto [low, high] = std::ranges::minmax_element(points, {}, [](const Vec2d& p) { return p.y(); });
        return std::pair(*low, *high);
    };
    const auto [low_a, high_a] = ends(side);
    const auto [low_b, high_b] = ends(other_side);
    const Vec2d a = high_a - low_a, b = high_b - low_b;
    const double cross = cross2(a, b), angle = std::abs(std::atan2(cross, a.dot(b)));
    const bool narrows = std::abs(high_a.x() - high_b.x()) > std::abs(low_a.x() - low_b.x());
    if (!narrows || angle < kLeastAngle || angle > kMostAngle) return std::nullopt;
    const double t = cross2(low_b - low_a, b) / cross;
    return WrapCone{.apex = low_a + t * a, .sine = -angle / (2 * std::numbers::pi)};
}

bool bend_round_waist(Panel& panel, const TrunkSection& waist, double height) {
    constexpr double kOffWaist = 0.02;  // m, from the body to a waist that is bent round it
    constexpr double kOpen = 0.97;      // of a full turn, so that the edges do not meet
    constexpr double kShortest = 0.4;   // of a full turn: a shorter one is no skirt round the body
    WaistArc arc = waist_arc(panel);
    if (arc.radius == 0) return false;
    const auto way_to_front = [&] {  // rad, on the panel, from straight down
        const Vec2d middle = outline_box(panel, 1e-3).center() - arc.centre;
        return std::atan2(middle.x(), -middle.y());
    };
    // The cone is cut open above its apex: a skirt that was drawn hem up or aside is turned first.
    if (std::abs(way_to_front()) > std::numbers::pi / 4) {
        panel = mapped_panel(panel, Eigen::Affine2d(Eigen::Rotation2Dd(-way_to_front())));
        arc = waist_arc(panel);
    }
    const double full = 2 * std::numbers::pi;
    const double round = std::min(kOpen * full, arc.angle * arc.radius / (waist.reach + kOffWaist));
    if (round < kShortest * full) return false;
    panel.wrap_radius = 0;
    panel.wrap_cone = WrapCone{.apex = arc.centre, .sine = std::min(1.0, arc.angle / round)};
    panel.rotation = Eigen::AngleAxisd(-way_to_front() / panel.wrap_cone->sine, Vec3d::UnitY()).toRotationMatrix();
    const double below = arc.radius * std::sqrt(1 - panel.wrap_cone->sine * panel.wrap_cone->sine);
    panel.translation = Vec3d(waist.centre.x(), height, waist.centre.z()) -
                        panel.rotation * Vec3d(arc.centre.x(), arc.centre.y() - below, 0);
    return true;
}

namespace {

// Whether both edges meet at a vertex: they are the legs of a dart.
bool is_dart(const Panel& panel, const SewnEdge& sewn) {
    const OutlineEdge &own = panel.edges[as_size(sewn.own.edge)], &other = panel.edges[as_size(sewn.other.edge)];
    return own.start == other.end || own.end == other.start;
}

}  // namespace

std::optional<WrapCone> cone_of_sleeve(const Pattern& pattern, const SewnEdges& sewn, std::size_t p) {
    std::vector<int> left, right;
    for (const SewnEdge& one : sewn[p]) {
        if (as_size(one.panel) != p || one.own == one.other || is_dart(pattern.panels[p], one)) continue;
        const bool is_left = middle_of_edge(pattern, one.own).x() < middle_of_edge(pattern, one.other).x();
        (is_left ? left : right).push_back(one.own.edge);
    }
    if (left.empty() || right.empty()) return std::nullopt;
    return tapering_cone(pattern.panels[p], left, right);
}

Panel part_below(const Panel& panel, double top) {
    Panel part = panel;
    if (top >= outline_box(panel, 1e-3).max().y()) return part;
    for (Vec2d& v : part.vertices) v.y() = std::min(v.y(), top);
    for (OutlineEdge& edge : part.edges) edge.kind = CurveKind::Line;
    return part;
}

}  // namespace selvedge::sim
