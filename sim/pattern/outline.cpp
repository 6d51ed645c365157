#include "sim/pattern/outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "sim/core/assert.h"
#include "sim/pattern/segment_distance.h"

namespace selvedge::sim {
namespace {

// A radius of less than half the chord is increased to half the chord, as in SVG; loading reports such arcs as errors.
ArcCircle circle_of(const Vec2d& start, const Vec2d& end, const OutlineEdge& edge) {
    const Vec2d chord = end - start;
    const double half = chord.norm() / 2;
    const double radius = std::max(edge.arc_radius, half);
    const double height = std::sqrt(std::max(0.0, radius * radius - half * half));
    const Vec2d left = half > 0 ? Vec2d(-chord.y(), chord.x()) / (2 * half) : Vec2d(0, 0);
    // A short arc that turns left has its centre to the left of the chord; each of the two flags mirrors the centre.
    const double side = edge.turns_right == edge.is_large_arc ? 1.0 : -1.0;
    const Vec2d centre = (start + end) / 2 + side * height * left;
    const double short_sweep = 2 * std::asin(std::min(1.0, half / radius));
    const double sweep = edge.is_large_arc ? 2 * std::numbers::pi - short_sweep : short_sweep;
    const Vec2d spoke = start - centre;
    return {centre, radius, std::atan2(spoke.y(), spoke.x()), edge.turns_right ? -sweep : sweep};
}

Vec2d arc_point(const ArcCircle& arc, double s) {
    const double angle = arc.from + s * arc.sweep;
    return arc.centre + arc.radius * Vec2d(std::cos(angle), std::sin(angle));
}

// A Bezier curve of degree 1 to 3, degree-elevated to a cubic: same curve, same parameter.
using Cubic = std::array<Vec2d, 4>;

Cubic as_cubic(const Vec2d& start, const Vec2d& end, const OutlineEdge& edge) {
    switch (edge.kind) {
        case CurveKind::Quadratic:
            return {start, start + 2.0 / 3.0 * (edge.control[0] - start), end + 2.0 / 3.0 * (edge.control[0] - end),
                    end};
        case CurveKind::Cubic:
            return {start, edge.control[0], edge.control[1], end};
        default:
            return {start, start + (end - start) / 3, end - (end - start) / 3, end};
    }
}

Vec2d cubic_point(const Cubic& p, double s) {
    const double r = 1 - s;
    return r * r * r * p[0] + 3 * r * r * s * p[1] + 3 * r * s * s * p[2] + s * s * s * p[3];
}

double cubic_speed(const Cubic& p, double s) {
    const double r = 1 - s;
    return (3 * r * r * (p[1] - p[0]) + 6 * r * s * (p[2] - p[1]) + 3 * s * s * (p[3] - p[2])).norm();
}

// Arc length by five-point Gauss-Legendre quadrature.
double gauss_length(const Cubic& p, double from, double to) {
    constexpr std::array<double, 3> node{0.0, 0.5384693101056831, 0.9061798459386640};
    constexpr std::array<double, 3> weight{0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    const double middle = (from + to) / 2;
    const double half = (to - from) / 2;
    double sum = weight[0] * cubic_speed(p, middle);
    for (std::size_t i = 1; i < 3; ++i) {
        sum += weight[i] * (cubic_speed(p, middle - half * node[i]) + cubic_speed(p, middle + half * node[i]));
    }
    return sum * half;
}

// Adaptive quadrature: halves the range until the halves agree with the whole to 1e-10. Needed near a cusp, where the
// speed is zero.
double cubic_length(const Cubic& p, double from, double to, int depth = 0) {
    const double middle = (from + to) / 2;
    const double whole = gauss_length(p, from, to);
    const double halves = gauss_length(p, from, middle) + gauss_length(p, middle, to);
    if (depth >= 16 || std::abs(halves - whole) <= 1e-10 * halves) return halves;
    return cubic_length(p, from, middle, depth + 1) + cubic_length(p, middle, to, depth + 1);
}

constexpr int kCells = 16;  // of the table of arc lengths

EdgeLengths lengths_of(const Cubic& p) {
    EdgeLengths lengths;
    for (int i = 0; i < kCells; ++i) {
        const auto cell = static_cast<std::size_t>(i);
        lengths.reached[cell + 1] = lengths.reached[cell] + cubic_length(p, double(i) / kCells, double(i + 1) / kCells);
    }
    return lengths;
}

// The parameter at which the arc length from the start is the fraction t of the whole: lookup in the table, then
// bisection within the cell.
double parameter_at(const Cubic& p, const EdgeLengths& lengths, double t) {
    const auto& reached = lengths.reached;
    const double wanted = t * reached.back();
    const auto above = std::upper_bound(reached.begin() + 1, reached.end() - 1, wanted);
    const auto cell = static_cast<std::size_t>(above - reached.begin() - 1);
    double low = double(cell) / kCells;
    double high = double(cell + 1) / kCells;
    double reached_low = reached[cell];
    for (int i = 0; i < 40 && high - low > 1e-12; ++i) {
        const double middle = (low + high) / 2;
        const double at_middle = reached_low + gauss_length(p, low, middle);
        if (at_middle < wanted) {
            low = middle;
            reached_low = at_middle;
        } else {
            high = middle;
        }
    }
    return (low + high) / 2;
}

struct Ends {
    Vec2d start;
    Vec2d end;
};

Ends ends_of(const Panel& panel, const OutlineEdge& edge) {
    const auto count = static_cast<int>(panel.vertices.size());
    SELVEDGE_ASSERT(edge.start >= 0 && edge.start < count && edge.end >= 0 && edge.end < count);
    return {panel.vertices[static_cast<std::size_t>(edge.start)], panel.vertices[static_cast<std::size_t>(edge.end)]};
}

}  // namespace

Vec2d outline_point(const Panel& panel, const OutlineEdge& edge, double t) {
    const auto [start, end] = ends_of(panel, edge);
    if (t <= 0) return start;
    if (t >= 1) return end;
    if (edge.kind == CurveKind::Line) return start + t * (end - start);
    if (edge.kind == CurveKind::Arc) return arc_point(circle_of(start, end, edge), t);
    const Cubic cubic = as_cubic(start, end, edge);
    return cubic_point(cubic, parameter_at(cubic, lengths_of(cubic), t));
}

EdgeLengths measure_lengths(const Panel& panel, const OutlineEdge& edge) {
    if (edge.kind == CurveKind::Line || edge.kind == CurveKind::Arc) return {};
    const auto [start, end] = ends_of(panel, edge);
    return lengths_of(as_cubic(start, end, edge));
}

Vec2d outline_point(const Panel& panel, const OutlineEdge& edge, const EdgeLengths& lengths, double t) {
    if (t <= 0 || t >= 1 || edge.kind == CurveKind::Line || edge.kind == CurveKind::Arc)
        return outline_point(panel, edge, t);
    const auto [start, end] = ends_of(panel, edge);
    const Cubic cubic = as_cubic(start, end, edge);
    return cubic_point(cubic, parameter_at(cubic, lengths, t));
}

double curve_parameter(const Panel& panel, const OutlineEdge& edge, double t) {
    if (t <= 0 || t >= 1 || edge.kind == CurveKind::Line || edge.kind == CurveKind::Arc) return std::clamp(t, 0.0, 1.0);
    const auto [start, end] = ends_of(panel, edge);
    const Cubic cubic = as_cubic(start, end, edge);
    return parameter_at(cubic, lengths_of(cubic), t);
}

double curve_fraction(const Panel& panel, const OutlineEdge& edge, double s) {
    if (s <= 0 || s >= 1 || edge.kind == CurveKind::Line || edge.kind == CurveKind::Arc) return std::clamp(s, 0.0, 1.0);
    const auto [start, end] = ends_of(panel, edge);
    const Cubic cubic = as_cubic(start, end, edge);
    const double before = cubic_length(cubic, 0, s);
    const double after = cubic_length(cubic, s, 1);
    return before + after > 0 ? before / (before + after) : s;
}

ArcCircle arc_circle(const Panel& panel, const OutlineEdge& edge) {
    const auto [start, end] = ends_of(panel, edge);
    return circle_of(start, end, edge);
}

double outline_length(const Panel& panel, const OutlineEdge& edge) {
    const auto [start, end] = ends_of(panel, edge);
    if (edge.kind == CurveKind::Line) return (end - start).norm();
    if (edge.kind == CurveKind::Arc) {
        const ArcCircle arc = circle_of(start, end, edge);
        return arc.radius * std::abs(arc.sweep);
    }
    return cubic_length(as_cubic(start, end, edge), 0, 1);
}

Vec2d curve_point(const Panel& panel, const OutlineEdge& edge, double s) {
    const auto [start, end] = ends_of(panel, edge);
    if (s <= 0) return start;
    if (s >= 1) return end;
    if (edge.kind == CurveKind::Arc) return arc_point(circle_of(start, end, edge), s);
    return cubic_point(as_cubic(start, end, edge), s);
}

std::vector<Vec2d> outline_polyline(const Panel& panel, const OutlineEdge& edge, double chord_error) {
    const auto [start, end] = ends_of(panel, edge);
    if (edge.kind == CurveKind::Line) return {start, end};
    int segments = 1;
    if (edge.kind == CurveKind::Arc) {
        const ArcCircle arc = circle_of(start, end, edge);
        const double step = 2 * std::acos(std::max(0.0, 1 - chord_error / std::max(arc.radius, chord_error)));
        segments = static_cast<int>(std::ceil(std::min(4096.0, std::abs(arc.sweep) / std::max(step, 1e-3))));
    } else {
        // The distance of the chord of a parameter step h from the curve is at most h^2/8 times the largest second
        // derivative.
        const Cubic p = as_cubic(start, end, edge);
        const double bend =
            6 * std::max((p[0] - 2 * p[1] + p[2]).norm(), (p[1] - 2 * p[2] + p[3]).norm()) / (8 * chord_error);
        segments = static_cast<int>(std::ceil(std::sqrt(std::clamp(bend, 1.0, 4096.0 * 4096.0))));
    }
    std::vector<Vec2d> points;
    for (int i = 0; i <= segments; ++i) points.push_back(curve_point(panel, edge, double(i) / segments));
    return points;
}

double outline_area(const Panel& panel) {
    double twice = 0;
    for (const OutlineEdge& edge : panel.edges) {
        const std::vector<Vec2d> points = outline_polyline(panel, edge, 1e-4);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) twice += cross2(points[i], points[i + 1]);
    }
    return twice / 2;
}

namespace {

constexpr double kCrossingError = 1e-4;  // m, chord error of the sampled curves

// A segment of the sampled outline, and the edge that it belongs to.
struct Piece {
    Vec2d from;
    Vec2d to;
    std::size_t edge;
    std::size_t order;  // index along the loop

    double left() const { return std::min(from.x(), to.x()); }
    double right() const { return std::max(from.x(), to.x()); }
    double bottom() const { return std::min(from.y(), to.y()); }
    double top() const { return std::max(from.y(), to.y()); }
};

std::vector<Piece> sample_outline(const Panel& panel) {
    std::vector<Piece> pieces;
    for (std::size_t e = 0; e < panel.edges.size(); ++e) {
        const std::vector<Vec2d> points = outline_polyline(panel, panel.edges[e], kCrossingError);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            if (points[i] != points[i + 1]) pieces.push_back({points[i], points[i + 1], e, pieces.size()});
        }
    }
    return pieces;
}

double side_of(const Piece& piece, const Vec2d& p) {
    return cross2(piece.to - piece.from, p - piece.from);
}

bool touches(const Piece& piece, const Vec2d& p, double clearance) {
    if (clearance == 0) return side_of(piece, p) == 0 && (p - piece.from).dot(p - piece.to) <= 0;
    const Vec2d along = piece.to - piece.from;
    const double s = std::clamp(along.dot(p - piece.from) / along.squaredNorm(), 0.0, 1.0);
    return (piece.from + s * along - p).norm() <= clearance;
}

// The point where two segments cross or touch, if any.
std::optional<Vec2d> meeting(const Piece& a, const Piece& b, double clearance) {
    const double b_from = side_of(a, b.from);
    const double b_to = side_of(a, b.to);
    const double a_from = side_of(b, a.from);
    const double a_to = side_of(b, a.to);
    const auto parted = [](double one, double other) { return (one > 0 && other < 0) || (one < 0 && other > 0); };
    if (parted(b_from, b_to) && parted(a_from, a_to)) return Vec2d(b.from + b_from / (b_from - b_to) * (b.to - b.from));
    for (const Vec2d& p : {b.from, b.to}) {
        if (touches(a, p, clearance)) return p;
    }
    for (const Vec2d& p : {a.from, a.to}) {
        if (touches(b, p, clearance)) return p;
    }
    return {};
}

// Neighbouring segments share an end; they overlap only if the second runs back along the first.
bool folds_back(const Piece& first, const Piece& next, double clearance) {
    const Vec2d d = first.to - first.from;
    const Vec2d e = next.to - next.from;
    return std::abs(cross2(d, e)) <= clearance * std::max(d.norm(), e.norm()) && d.dot(e) < 0;
}

std::optional<Vec2d> crossing(const Piece& a, const Piece& b, std::size_t count, double clearance) {
    const bool b_follows = (a.order + 1) % count == b.order;
    const bool a_follows = (b.order + 1) % count == a.order;
    if (!b_follows && !a_follows) return meeting(a, b, clearance);
    if (b_follows && folds_back(a, b, clearance)) return b.from;
    if (a_follows && folds_back(b, a, clearance)) return a.from;
    return {};
}

}  // namespace

// Sorts the segments by their left end, and tests each pair whose boxes overlap once.
std::vector<OutlineCrossing> find_outline_crossings(const Panel& panel, const CrossingSearch& search) {
    std::vector<Piece> pieces = sample_outline(panel);
    std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.left() < b.left(); });
    std::vector<OutlineCrossing> found;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (std::size_t k = i + 1; k < pieces.size() && pieces[k].left() <= pieces[i].right() + search.clearance;
             ++k) {
            const bool is_apart = pieces[k].bottom() > pieces[i].top() + search.clearance ||
                                  pieces[i].bottom() > pieces[k].top() + search.clearance;
            if (is_apart) continue;
            const std::optional<Vec2d> place = crossing(pieces[i], pieces[k], pieces.size(), search.clearance);
            if (!place) continue;
            const auto [first, second] = std::minmax(pieces[i].edge, pieces[k].edge);
            const auto is_known = [&, one = first, other = second](const OutlineCrossing& known) {
                return known.first == one && known.second == other;
            };
            if (std::any_of(found.begin(), found.end(), is_known)) continue;
            found.push_back({first, second, *place});
            if (found.size() >= search.most) return found;
        }
    }
    return found;
}

bool is_inside(const Vec2d& point, std::span<const Vec2d> outline) {
    bool inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        if (is_crossed_rightwards(point, outline[i], outline[(i + 1) % outline.size()])) inside = !inside;
    }
    return inside;
}

}  // namespace selvedge::sim
