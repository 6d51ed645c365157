#include "editor/inspectors/pattern_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "editor/geometry/draft.h"
#include "editor/geometry/outline_edit.h"
#include "editor/geometry/panel_edit.h"
#include "editor/geometry/seam_edit.h"
#include "editor/geometry/sewing.h"
#include "editor/inspectors/number_box.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {
namespace {

const Vec2d& start_of(const sim::Panel& panel, const sim::OutlineEdge& edge) {
    return panel.vertices[static_cast<std::size_t>(edge.start)];
}

const Vec2d& end_of(const sim::Panel& panel, const sim::OutlineEdge& edge) {
    return panel.vertices[static_cast<std::size_t>(edge.end)];
}

// Control points of a cubic with the edge's end points, end tangents and mid-height.
std::array<Vec2d, 2> cubic_controls(const sim::Panel& panel, const sim::OutlineEdge& edge) {
    const Vec2d a = start_of(panel, edge), d = end_of(panel, edge);
    switch (edge.kind) {
        case sim::CurveKind::Line:
            return {a + (d - a) / 3, a + (d - a) * 2 / 3};
        case sim::CurveKind::Quadratic:
            return {a + (edge.control[0] - a) * 2 / 3, d + (edge.control[0] - d) * 2 / 3};
        case sim::CurveKind::Cubic:
            return edge.control;
        case sim::CurveKind::Arc:
            break;
    }
    // Other curves: the cubic through the edge's points at 1/3 and 2/3.
    const Vec2d p = curve_point(panel, edge, 1.0 / 3), q = curve_point(panel, edge, 2.0 / 3);
    const Vec2d u = (27 * p - 8 * a - d) / 6, v = (27 * q - a - 8 * d) / 6;  // 2 b + c, b + 2 c
    return {(2 * u - v) / 3, (2 * v - u) / 3};
}

// Control point of the quadratic through the edge's end points and mid-point: twice the mid-point minus the mean of the
// ends.
Vec2d quadratic_control(const sim::Panel& panel, const sim::OutlineEdge& edge) {
    const Vec2d a = start_of(panel, edge), d = end_of(panel, edge);
    if (edge.kind == sim::CurveKind::Quadratic) return edge.control[0];
    return 2 * outline_point(panel, edge, 0.5) - (a + d) / 2;
}

// The arc through the edge's end points and mid-point. An almost straight edge gives an arc with a rise of a tenth of
// the chord.
void set_arc(const sim::Panel& panel, const sim::OutlineEdge& edge, sim::OutlineEdge& arc) {
    const Vec2d a = start_of(panel, edge), d = end_of(panel, edge);
    const double chord = (d - a).norm();
    if (!(chord > 0)) return;
    const Vec2d left(-(d - a).y() / chord, (d - a).x() / chord);
    double height = (outline_point(panel, edge, 0.5) - (a + d) / 2).dot(left);
    constexpr double kFlat = 0.01;  // fraction of the chord
    if (std::abs(height) < kFlat * chord) height = -0.1 * chord;
    arc.arc_radius = (chord * chord / 4 + height * height) / (2 * std::abs(height));
    arc.is_large_arc = std::abs(height) > chord / 2;
    arc.turns_right = height > 0;
}

}  // namespace

Vec3d garment_centre(const sim::Pattern& pattern) {
    Vec3d low = Vec3d::Constant(std::numeric_limits<double>::max()), high = -low;
    bool is_empty = true;
    for (const sim::Panel& panel : pattern.panels) {
        for (const Vec2d& u : panel.vertices) {
            const Vec3d x = panel.place(u);
            low = low.cwiseMin(x);
            high = high.cwiseMax(x);
            is_empty = false;
        }
    }
    return is_empty ? Vec3d::Zero() : Vec3d((low + high) / 2);
}

// R = Rz Ry Rx has -sin y at its lower left. Where cos y = 0, only z - x or z + x is determined.
Vec3d angles_of(const Eigen::Matrix3d& r) {
    constexpr double kNoCosine = 1e-9;
    const double cosine = std::hypot(r(0, 0), r(1, 0));
    const double y = std::atan2(-r(2, 0), cosine);
    if (cosine < kNoCosine) return {0, y, std::atan2(-r(0, 1), r(1, 1))};
    return {std::atan2(r(2, 1), r(2, 2)), y, std::atan2(r(1, 0), r(0, 0))};
}

Eigen::Matrix3d rotation_of(const Vec3d& angles) {
    return (Eigen::AngleAxisd(angles.z(), Vec3d::UnitZ()) * Eigen::AngleAxisd(angles.y(), Vec3d::UnitY()) *
            Eigen::AngleAxisd(angles.x(), Vec3d::UnitX()))
        .toRotationMatrix();
}

double panel_perimeter(const sim::Panel& panel) {
    double sum = 0;
    for (const sim::OutlineEdge& edge : panel.edges) sum += outline_length(panel, edge);
    return sum;
}

PlaneMap scale_about(const Vec2d& centre, const Vec2d& factors) {
    return {
        .x_axis = {factors.x(), 0}, .y_axis = {0, factors.y()}, .shift = centre - Vec2d(factors.cwiseProduct(centre))};
}

sim::OutlineEdge with_kind(const sim::Panel& panel, const sim::OutlineEdge& edge, sim::CurveKind kind) {
    sim::OutlineEdge curve = edge;
    curve.kind = kind;
    curve.control = {Vec2d::Zero(), Vec2d::Zero()};
    curve.arc_radius = 0;
    curve.is_large_arc = curve.turns_right = false;
    switch (kind) {
        case sim::CurveKind::Line:
            break;
        case sim::CurveKind::Quadratic:
            curve.control[0] = quadratic_control(panel, edge);
            break;
        case sim::CurveKind::Cubic:
            curve.control = cubic_controls(panel, edge);
            break;
        case sim::CurveKind::Arc:
            if (edge.kind == sim::CurveKind::Arc) return edge;
            set_arc(panel, edge, curve);
            break;
    }
    return curve;
}

// Assumes that the chord grows in proportion to the curve's length.
Vec2d shift_for_length(const sim::Panel& panel, const sim::OutlineEdge& edge, const LengthChange& change) {
    const double now = outline_length(panel, edge);
    if (!(now > 0 && change.before > 0 && change.after > 0)) return Vec2d::Zero();
    return (end_of(panel, edge) - start_of(panel, edge)) * ((change.after - change.before) / now);
}

namespace {

// Both ends of the edge by the similarity that takes them there, in the panel's frame.
TransformVertices both_ends_to(const sim::Panel& panel, const sim::OutlineEdge& edge, const Vec2d& start,
                               const Vec2d& end, const Vec2d& origin) {
    const Eigen::Affine2d map = sim::chord_map(start_of(panel, edge), end_of(panel, edge), start, end);
    const Vec2d shift = origin + map.translation() - map.linear() * origin;  // the origin of the panel on the sheet
    return {.vertices = {{panel.name, edge.start}, {panel.name, edge.end}},
            .map = {map.linear().col(0), map.linear().col(1), shift},
            .what = "Change length"};
}

}  // namespace

Command command_for_length(const sim::Pattern& pattern, const PartRef& edge, LengthMove move,
                           const LengthChange& change) {
    const auto index = static_cast<std::size_t>(panel_index(pattern, edge.panel).value());
    const sim::Panel& panel = pattern.panels[index];
    const auto count = panel.edges.size();
    const auto at = static_cast<std::size_t>(edge.index);
    const sim::OutlineEdge& curve = panel.edges[at];
    const Vec2d by = shift_for_length(panel, curve, change);
    if (move == LengthMove::End) return MoveVertices{.vertices = {{edge.panel, curve.end}}, .by = by};
    if (move == LengthMove::Start) return MoveVertices{.vertices = {{edge.panel, curve.start}}, .by = -by};
    const Vec2d origin = sheet_positions(pattern)[index];
    const Vec2d start = start_of(panel, curve), end = end_of(panel, curve);
    if (move == LengthMove::Both) return both_ends_to(panel, curve, start - by / 2, end + by / 2, origin);
    // The ends slide by d / sine of the angle to their neighbours, which adds d times the difference of the cotangents.
    const sim::OutlineEdge &before = panel.edges[(at + count - 1) % count], &after = panel.edges[(at + 1) % count];
    const Vec2d chord = end - start, along = chord.normalized(), across(-along.y(), along.x());
    const Vec2d first = start_of(panel, before) - start, second = end_of(panel, after) - end;
    constexpr double kParallel = 1e-6;
    const double first_sine = first.normalized().dot(across), second_sine = second.normalized().dot(across);
    const bool has_sides = std::abs(first_sine) > kParallel && std::abs(second_sine) > kParallel;
    const double gain = has_sides ? second.dot(along) / second.dot(across) - first.dot(along) / first.dot(across) : 0.0;
    if (std::abs(gain) < kParallel)
        throw GeometryError("The neighbours of this edge are parallel: it cannot become longer or shorter between them",
                            {{.panel = edge.panel, .edge = edge.index}});
    const double grown = by.dot(along), offset = grown / gain;
    return both_ends_to(panel, curve, start + offset / first.dot(across) * first,
                        end + offset / second.dot(across) * second, origin);
}

double min_arc_radius(const sim::Panel& panel, const sim::OutlineEdge& edge) {
    return (end_of(panel, edge) - start_of(panel, edge)).norm() / 2;
}

SeamMeasures seam_measures(const sim::Pattern& pattern, int seam) {
    const sim::Seam& held = pattern.seams[static_cast<std::size_t>(seam)];
    const std::vector<int> parts = sewing_of(pattern, seam);
    const std::array<double, 2> lengths = sewing_lengths(pattern, seam);
    SeamMeasures measures{.name = parts.size() > 1 ? held.sewing : seam_name(pattern, held),
                          .first = lengths[0],
                          .second = lengths[1],
                          .is_eased = held.is_eased};
    for (const int part : parts) {
        const sim::Seam& sewn = pattern.seams[static_cast<std::size_t>(part)];
        const std::array<double, 2> sides = seam_lengths(pattern, sewn);
        measures.is_uneven = measures.is_uneven || std::abs(sides[0] - sides[1]) > kUnevenSeam;
        measures.is_eased = measures.is_eased && sewn.is_eased;
        if (parts.size() > 1) measures.parts.push_back(seam_name(pattern, sewn));
    }
    return measures;
}

std::string difference_text(const SeamMeasures& measures) {
    const std::string text = quantity_text(measures.difference(), Unit::Millimetres);
    return text.front() == '-' || text == "0 mm" ? text : "+" + text;
}

}  // namespace selvedge::editor
