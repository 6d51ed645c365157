#include "sim/pattern/edge_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "sim/core/math.h"
#include "sim/pattern/edge_keys.h"
#include "sim/pattern/field_moves.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

const Vec2d& start_of(const Panel& panel, const OutlineEdge& edge) {
    return panel.vertices[as_size(edge.start)];
}

const Vec2d& end_of(const Panel& panel, const OutlineEdge& edge) {
    return panel.vertices[as_size(edge.end)];
}

Vec2d between(const Vec2d& a, const Vec2d& b, double s) {
    return a + s * (b - a);
}

Vec2d to_the_left(const Vec2d& v) {
    return {-v.y(), v.x()};
}

void split_controls(const Panel& panel, const OutlineEdge& edge, double s, SplitCurve& out) {
    const Vec2d start = start_of(panel, edge);
    const Vec2d end = end_of(panel, edge);
    if (edge.kind == CurveKind::Quadratic) {
        out.before.control[0] = between(start, edge.control[0], s);
        out.after.control[0] = between(edge.control[0], end, s);
        out.point = between(out.before.control[0], out.after.control[0], s);
        return;
    }
    const Vec2d first = between(start, edge.control[0], s);
    const Vec2d middle = between(edge.control[0], edge.control[1], s);
    const Vec2d last = between(edge.control[1], end, s);
    out.before.control = {first, between(first, middle, s)};
    out.after.control = {between(middle, last, s), last};
    out.point = between(out.before.control[1], out.after.control[0], s);
}

// The least-squares cubic through points, with given end tangents (P. J. Schneider, "An Algorithm for Automatically
// Fitting Digitized Curves", Graphics Gems, 1990).
class CubicFit {
 public:
    CubicFit(const std::vector<Vec2d>& points, const Vec2d& start_direction, const Vec2d& end_direction)
        : points_(points), from_(start_direction), back_(-end_direction) {
        double length = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i > 0) length += (points[i] - points[i - 1]).norm();
            u_.push_back(length);
        }
        for (double& u : u_) u /= length;
        handles_ = Vec2d::Constant(length / 3);
    }

    std::array<Vec2d, 2> controls() {
        constexpr int kRounds = 30;
        for (int round = 0; round < kRounds; ++round) {
            if (!fit_handles()) break;
            for (std::size_t i = 1; i + 1 < u_.size(); ++i) improve(points_[i], u_[i]);
        }
        return current();
    }

 private:
    std::array<Vec2d, 2> current() const {
        return {points_.front() + handles_[0] * from_, points_.back() + handles_[1] * back_};
    }

    bool fit_handles() {
        Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
        Vec2d right = Vec2d::Zero();
        for (std::size_t i = 0; i < u_.size(); ++i) {
            const double u = u_[i];
            const double r = 1 - u;
            const Vec2d a = 3 * r * r * u * from_;
            const Vec2d b = 3 * r * u * u * back_;
            const Vec2d rest =
                points_[i] - (r * r * (1 + 2 * u) * points_.front() + u * u * (1 + 2 * r) * points_.back());
            normal += (Eigen::Matrix2d() << a.dot(a), a.dot(b), a.dot(b), b.dot(b)).finished();
            right += Vec2d(a.dot(rest), b.dot(rest));
        }
        if (std::abs(normal.determinant()) <= 1e-12 * normal.squaredNorm()) return false;
        const Vec2d found = normal.inverse() * right;
        const double chord = (points_.back() - points_.front()).norm();
        if (!found.allFinite() || found.minCoeff() < 1e-3 * chord) return false;
        handles_ = found;
        return true;
    }

    // One Newton step towards the parameter of the curve point nearest to `point`.
    void improve(const Vec2d& point, double& u) const {
        const auto [b, c] = current();
        const Vec2d& a = points_.front();
        const Vec2d& d = points_.back();
        const double r = 1 - u;
        const Vec2d off = r * r * r * a + 3 * r * r * u * b + 3 * r * u * u * c + u * u * u * d - point;
        const Vec2d first = 3 * (r * r * (b - a) + 2 * r * u * (c - b) + u * u * (d - c));
        const Vec2d second = 6 * (r * (c - 2 * b + a) + u * (d - 2 * c + b));
        const double slope = first.squaredNorm() + off.dot(second);
        if (slope > 0) u = std::clamp(u - off.dot(first) / slope, 0.0, 1.0);
    }

    const std::vector<Vec2d>& points_;
    Vec2d from_;
    Vec2d back_;
    std::vector<double> u_;
    Vec2d handles_ = Vec2d::Zero();
};

// Inverse of split_curve (de Casteljau backwards). None: the two edges are not parts of one curve.
std::optional<OutlineEdge> rejoined(const Panel& panel, const OutlineEdge& a, const OutlineEdge& b) {
    if (a.kind != b.kind || a.kind == CurveKind::Line) return {};
    OutlineEdge whole = a;
    whole.end = b.end;
    double t = 0;  // parameter of the joint on the whole curve
    if (a.kind == CurveKind::Arc) {
        const ArcCircle one = arc_circle(panel, a);
        const ArcCircle two = arc_circle(panel, b);
        if (a.turns_right != b.turns_right || std::abs(one.sweep + two.sweep) > 1.99 * std::numbers::pi) return {};
        whole.is_large_arc = std::abs(one.sweep + two.sweep) > std::numbers::pi;
        t = one.sweep / (one.sweep + two.sweep);
    } else {
        const Vec2d joint = end_of(panel, a);
        const std::size_t last = a.kind == CurveKind::Cubic ? 1 : 0;
        const double before = (joint - a.control[last]).norm();
        const double after = (b.control[0] - joint).norm();
        if (before < 1e-9 || after < 1e-9) return {};
        t = before / (before + after);
        whole.control[0] = start_of(panel, a) + (a.control[0] - start_of(panel, a)) / t;
        if (last == 1) whole.control[1] = end_of(panel, b) + (b.control[1] - end_of(panel, b)) / (1 - t);
    }
    for (const double s : {0.25, 0.5, 0.75, 1.0}) {
        const bool fits = (curve_point(panel, whole, s * t) - curve_point(panel, a, s)).norm() < 1e-7 &&
                          (curve_point(panel, whole, t + s * (1 - t)) - curve_point(panel, b, s)).norm() < 1e-7;
        if (!fits) return {};
    }
    return whole;
}

OutlineEdge arc_as_cubic(const Panel& panel, const OutlineEdge& edge) {
    const ArcCircle circle = arc_circle(panel, edge);
    if (std::abs(circle.sweep) > std::numbers::pi * 1.01) return joined_curve(panel, {edge});  // best single cubic
    OutlineEdge cubic = straightened(edge);
    cubic.kind = CurveKind::Cubic;
    const double handle = circle.radius * 4 / 3 * std::tan(std::abs(circle.sweep) / 4);
    cubic.control = {start_of(panel, edge) + handle * curve_direction(panel, edge, EdgeEnd::Start),
                     end_of(panel, edge) - handle * curve_direction(panel, edge, EdgeEnd::End)};
    return cubic;
}

bool is_similarity(const Eigen::Affine2d& map) {
    const Eigen::Matrix2d square = map.linear().transpose() * map.linear();
    const double size = square.trace() / 2;
    return (square - size * Eigen::Matrix2d::Identity()).cwiseAbs().maxCoeff() <= 1e-9 * size;
}

}  // namespace

SplitCurve split_curve(const Panel& panel, const OutlineEdge& edge, double t, int vertex) {
    SplitCurve out{edge, edge};
    const double s = curve_parameter(panel, edge, t);
    if (edge.kind == CurveKind::Quadratic || edge.kind == CurveKind::Cubic) {
        split_controls(panel, edge, s, out);
    } else {
        out.point = curve_point(panel, edge, s);
    }
    if (edge.kind == CurveKind::Arc) {
        const ArcCircle circle = arc_circle(panel, edge);
        out.before.arc_radius = out.after.arc_radius = circle.radius;
        out.before.is_large_arc = std::abs(circle.sweep) * s > std::numbers::pi;
        out.after.is_large_arc = std::abs(circle.sweep) * (1 - s) > std::numbers::pi;
    }
    out.before.end = vertex;
    out.after.start = vertex;
    out.after.key = {};
    return out;
}

void split_edge(Panel& panel, int edge, double t) {
    SplitCurve split = split_curve(panel, panel.edges[as_size(edge)], t, static_cast<int>(panel.vertices.size()));
    split.after.key = new_part_key(panel, split.before);
    panel.vertices.push_back(split.point);
    panel.edges[as_size(edge)] = split.before;
    panel.edges.insert(panel.edges.begin() + edge + 1, split.after);
    for (Notch& notch : panel.notches) {
        if (notch.edge > edge || (notch.edge == edge && notch.t > t)) {
            if (notch.edge++ == edge) notch.t = std::clamp((notch.t - t) / (1 - t), 0.0, 1.0);
        } else if (notch.edge == edge) {
            notch.t = std::min(1.0, notch.t / t);
        }
    }
}

OutlineEdge straightened(OutlineEdge edge) {
    edge.kind = CurveKind::Line;
    edge.control = OutlineEdge().control;
    edge.arc_radius = 0;
    edge.is_large_arc = false;
    edge.turns_right = false;
    return edge;
}

OutlineEdge reversed_edge(const OutlineEdge& edge) {
    OutlineEdge other = edge;
    std::swap(other.start, other.end);
    if (edge.kind == CurveKind::Cubic) std::swap(other.control[0], other.control[1]);
    if (edge.kind == CurveKind::Arc) other.turns_right = !edge.turns_right;
    reverse_fields(other);
    return other;
}

OutlineEdge mapped_curve(const Panel& panel, const OutlineEdge& edge, const Eigen::Affine2d& map) {
    const bool is_arc = edge.kind == CurveKind::Arc && is_similarity(map);
    OutlineEdge other = edge.kind == CurveKind::Arc && !is_arc ? arc_as_cubic(panel, edge) : edge;
    move_fields(other, {.map = map});
    if (is_arc) {
        const double determinant = map.linear().determinant();
        other.arc_radius *= std::sqrt(std::abs(determinant));
        if (determinant < 0) other.turns_right = !edge.turns_right;
    }
    if (other.kind == CurveKind::Quadratic || other.kind == CurveKind::Cubic) other.control[0] = map * other.control[0];
    if (other.kind == CurveKind::Cubic) other.control[1] = map * other.control[1];
    return other;
}

Eigen::Affine2d chord_map(const Vec2d& from_a, const Vec2d& from_b, const Vec2d& to_a, const Vec2d& to_b) {
    const Vec2d from = from_b - from_a;
    const Vec2d to = to_b - to_a;
    const double cosine = from.dot(to) / from.squaredNorm();
    const double sine = cross2(from, to) / from.squaredNorm();
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    map.linear() << cosine, -sine, sine, cosine;
    map.translation() = to_a - map.linear() * from_a;
    return map;
}

Vec2d curve_direction(const Panel& panel, const OutlineEdge& edge, EdgeEnd at) {
    const Vec2d start = start_of(panel, edge);
    const Vec2d end = end_of(panel, edge);
    const bool is_start = at == EdgeEnd::Start;
    if (edge.kind == CurveKind::Arc) {
        const ArcCircle circle = arc_circle(panel, edge);
        const Vec2d spoke = (is_start ? start : end) - circle.centre;
        return to_the_left(spoke).normalized() * (circle.sweep > 0 ? 1 : -1);
    }
    std::vector<Vec2d> polygon{start};
    if (edge.kind == CurveKind::Quadratic || edge.kind == CurveKind::Cubic) polygon.push_back(edge.control[0]);
    if (edge.kind == CurveKind::Cubic) polygon.push_back(edge.control[1]);
    polygon.push_back(end);
    if (!is_start) std::reverse(polygon.begin(), polygon.end());
    for (std::size_t i = 1; i < polygon.size(); ++i) {
        const Vec2d along = polygon[i] - polygon[0];
        if (along.norm() > 1e-9) return along.normalized() * (is_start ? 1 : -1);
    }
    return Vec2d(1, 0);
}

OutlineEdge joined_curve(const Panel& panel, const std::vector<OutlineEdge>& chain) {
    OutlineEdge joined = straightened(chain.front());
    joined.end = chain.back().end;
    if (std::all_of(chain.begin(), chain.end(), [](const OutlineEdge& e) { return e.kind == CurveKind::Line; })) {
        return joined;
    }
    std::optional<OutlineEdge> whole = chain.front();
    for (std::size_t i = 1; i < chain.size() && whole; ++i) whole = rejoined(panel, *whole, chain[i]);
    if (whole && chain.size() > 1) return *whole;
    constexpr int kSamples = 24;  // per edge
    std::vector<Vec2d> points{start_of(panel, chain.front())};
    for (const OutlineEdge& edge : chain) {
        for (int i = 1; i <= kSamples; ++i) points.push_back(curve_point(panel, edge, double(i) / kSamples));
    }
    joined.kind = CurveKind::Cubic;
    joined.control = CubicFit(points, curve_direction(panel, chain.front(), EdgeEnd::Start),
                              curve_direction(panel, chain.back(), EdgeEnd::End))
                         .controls();
    return joined;
}

void move_outline(Panel& panel, const VertexMove& move) {
    Panel moved = panel;
    for (std::size_t i = 0; i < panel.vertices.size(); ++i) {
        if (move.is_moved[i]) moved.vertices[i] = move.map * panel.vertices[i];
    }
    for (std::size_t e = 0; e < panel.edges.size(); ++e) {
        const OutlineEdge& edge = panel.edges[e];
        const bool has_start = move.is_moved[as_size(edge.start)];
        const bool has_end = move.is_moved[as_size(edge.end)];
        if (has_start && has_end) moved.edges[e] = mapped_curve(panel, edge, move.map);
        if (has_start == has_end || edge.kind == CurveKind::Line) continue;
        const Eigen::Affine2d ride =
            chord_map(start_of(panel, edge), end_of(panel, edge), start_of(moved, edge), end_of(moved, edge));
        moved.edges[e] = mapped_curve(panel, edge, ride);
    }
    panel = std::move(moved);
}

Panel mapped_panel(const Panel& panel, const Eigen::Affine2d& map) {
    const int count = static_cast<int>(panel.edges.size());
    const PlaneMove move{.map = map, .edge_count = count};
    Panel mapped = panel;
    move_fields(mapped, move);
    const bool is_upright = map.linear()(0, 1) == 0 && map.linear()(1, 0) == 0 && map.linear()(1, 1) > 0;
    if (!is_upright) mapped.wrap_cone.reset();  // its axis would be another one
    for (Vec2d& vertex : mapped.vertices) vertex = map * vertex;
    for (int e = 0; e < count; ++e) {
        const OutlineEdge edge = mapped_curve(panel, panel.edges[as_size(e)], map);
        const int index = move.is_mirror() ? mirrored_edge(e, count) : e;
        mapped.edges[as_size(index)] = move.is_mirror() ? reversed_edge(edge) : edge;
    }
    return mapped;
}

Eigen::Affine2d reflection_in(const Vec2d& from, const Vec2d& to) {
    const Vec2d along = (to - from).normalized();
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    map.linear() = 2 * along * along.transpose() - Eigen::Matrix2d::Identity();
    map.translation() = from - map.linear() * from;
    return map;
}

Panel unfolded(const Panel& half, int fold) {
    Panel panel = half;
    const int count = static_cast<int>(half.edges.size());
    const OutlineEdge& axis = half.edges[as_size(fold)];
    const Eigen::Affine2d map = reflection_in(start_of(half, axis), end_of(half, axis));
    std::vector<int> image(half.vertices.size());
    for (std::size_t v = 0; v < image.size(); ++v) image[v] = static_cast<int>(v);
    for (const OutlineEdge& edge : half.edges) {
        if (edge.start == axis.start || edge.start == axis.end) continue;
        image[as_size(edge.start)] = static_cast<int>(panel.vertices.size());
        panel.vertices.emplace_back(map * start_of(half, edge));
    }
    panel.edges.assign(as_size(2 * (count - 1)), {});
    panel.notches.clear();
    for (int e = 0; e < count; ++e) {
        if (e == fold) continue;
        OutlineEdge other = reversed_edge(mapped_curve(half, half.edges[as_size(e)], map));
        other.start = image[as_size(other.start)];
        other.end = image[as_size(other.end)];
        const EdgeKey key{other.key.number, EdgeRole::Image};
        if (has_keys(half)) other.key = find_edge(half, key) ? new_key(panel) : key;
        panel.edges[as_size(unfolded_index(e, fold, count))] = half.edges[as_size(e)];
        panel.edges[as_size(unfolded_image(e, fold, count))] = other;
    }
    for (Notch notch : half.notches) {
        if (notch.edge == fold) continue;
        const int edge = std::exchange(notch.edge, unfolded_index(notch.edge, fold, count));
        panel.notches.push_back(notch);
        notch.edge = unfolded_image(edge, fold, count);
        notch.t = 1 - notch.t;
        panel.notches.push_back(notch);
    }
    for (const int pin : half.pins) {
        if (image[as_size(pin)] != pin) panel.pins.push_back(image[as_size(pin)]);
    }
    Panel mirrored = half;
    move_fields(mirrored, {.map = map, .edge_count = count});
    gather_fields(panel, mirrored);
    return panel;
}

Eigen::AlignedBox2d outline_box(const Panel& panel, double chord_error) {
    Eigen::AlignedBox2d box;
    for (const OutlineEdge& edge : panel.edges) {
        for (const Vec2d& point : outline_polyline(panel, edge, chord_error)) box.extend(point);
    }
    return box.isEmpty() ? Eigen::AlignedBox2d(Vec2d(0, 0)) : box;
}

NearestOnEdge nearest_on_edge(const Panel& panel, const OutlineEdge& edge, const Vec2d& u) {
    const auto distance = [&](double s) { return (curve_point(panel, edge, s) - u).norm(); };
    if (edge.kind == CurveKind::Line) {
        const Vec2d start = panel.vertices[as_size(edge.start)];
        const Vec2d chord = panel.vertices[as_size(edge.end)] - start;
        const double size = chord.squaredNorm();
        const double t = size > 0 ? std::clamp(chord.dot(u - start) / size, 0.0, 1.0) : 0;
        return {t, distance(t)};
    }
    constexpr int kCells = 64;
    int best = 0;
    for (int i = 1; i <= kCells; ++i) {
        if (distance(double(i) / kCells) < distance(double(best) / kCells)) best = i;
    }
    double low = std::max(0.0, double(best - 1) / kCells);
    double high = std::min(1.0, double(best + 1) / kCells);
    while (high - low > 1e-9) {  // ternary search: the distance is unimodal within a cell
        const double one = low + (high - low) / 3;
        const double two = high - (high - low) / 3;
        (distance(one) <= distance(two) ? high : low) = distance(one) <= distance(two) ? two : one;
    }
    double s = (low + high) / 2;
    for (const double end : {0.0, 1.0}) {
        if (distance(end) <= distance(s)) s = end;
    }
    return {curve_fraction(panel, edge, s), distance(s)};
}

}  // namespace selvedge::sim
