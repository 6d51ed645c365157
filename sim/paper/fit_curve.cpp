#include "sim/paper/fit_curve.h"

#include <algorithm>
#include <cmath>

namespace selvedge::sim {
namespace {

using Points = std::span<const Vec2d>;

Vec2d derivative(const CubicPoints& c, double s) {
    const double r = 1 - s;
    return 3 * (r * r * (c[1] - c[0]) + 2 * r * s * (c[2] - c[1]) + s * s * (c[3] - c[2]));
}

Vec2d second_derivative(const CubicPoints& c, double s) {
    return 6 * ((1 - s) * (c[2] - 2 * c[1] + c[0]) + s * (c[3] - 2 * c[2] + c[1]));
}

std::vector<double> chord_parameters(Points points) {
    std::vector<double> s{0};
    for (std::size_t i = 1; i < points.size(); ++i) s.push_back(s.back() + (points[i] - points[i - 1]).norm());
    for (double& value : s) value /= s.back();
    s.back() = 1;
    return s;
}

// The distances of the control points along the tangents by least squares; a third of the chord where that fails.
CubicPoints fit_once(Points points, const std::vector<double>& s, const Vec2d& at_start, const Vec2d& at_end) {
    const Vec2d first = points.front(), last = points.back();
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Vec2d right = Vec2d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double t = s[i], r = 1 - t;
        const Vec2d a = 3 * r * r * t * at_start, b = 3 * r * t * t * at_end;
        const Vec2d rest = points[i] - (r * r * r + 3 * r * r * t) * first - (t * t * t + 3 * r * t * t) * last;
        normal(0, 0) += a.dot(a);
        normal(0, 1) += a.dot(b);
        normal(1, 1) += b.dot(b);
        right += Vec2d(a.dot(rest), b.dot(rest));
    }
    normal(1, 0) = normal(0, 1);
    const double chord = (last - first).norm(), determinant = normal.determinant();
    // Longer handles than the way along the points make a loop between them.
    double way = 0;
    for (std::size_t i = 1; i < points.size(); ++i) way += (points[i] - points[i - 1]).norm();
    Vec2d reach(chord / 3, chord / 3);
    if (std::abs(determinant) > 1e-12 * normal(0, 0) * normal(1, 1)) {
        const Vec2d solved = normal.inverse() * right;
        if (solved.minCoeff() > 1e-6 * chord && solved.maxCoeff() < way) reach = solved;
    }
    return {first, first + reach[0] * at_start, last + reach[1] * at_end, last};
}

// Newton's step towards the parameter that is nearest to each point.
void improve_parameters(Points points, const CubicPoints& c, std::vector<double>& s) {
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const Vec2d off = point_on(c, s[i]) - points[i];
        const Vec2d d = derivative(c, s[i]);
        const double slope = d.squaredNorm() + off.dot(second_derivative(c, s[i]));
        if (std::abs(slope) > 1e-300) s[i] = std::clamp(s[i] - off.dot(d) / slope, 0.0, 1.0);
    }
}

struct Worst {
    double distance = 0;
    std::size_t index = 0;
};

// How far a curve strays from the middle of a segment.
double strayed(Points points, const CubicPoints& c, const std::vector<double>& s, std::size_t i) {
    const Vec2d along = points[i + 1] - points[i];
    const double length = along.norm();
    if (!(length > 0)) return 0;
    return std::abs(cross2(along / length, point_on(c, (s[i] + s[i + 1]) / 2) - points[i]));
}

Worst worst_of(Points points, const CubicPoints& c, const std::vector<double>& s) {
    Worst worst{.index = points.size() / 2};
    for (const std::size_t i : {std::size_t{0}, points.size() - 2}) {
        const double distance = strayed(points, c, s, i);
        if (distance > worst.distance) worst = {distance, i == 0 ? 1 : i};
    }
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const double distance = (point_on(c, s[i]) - points[i]).norm();
        if (distance > worst.distance) worst = {distance, i};
    }
    return worst;
}

// The tangent of the parabola through the first point and two others, which are not so near that rounding counts.
Vec2d tangent_at_start(Points points) {
    constexpr double kNear = 0.01;  // of the length
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
    const auto beyond = [&](const Vec2d& from, std::size_t first) {
        while (first + 1 < points.size() && (points[first] - from).norm() < kNear * length) ++first;
        return first;
    };
    const std::size_t second = beyond(points[0], 1);
    const Vec2d a = points[second] - points[0];
    if (second + 1 >= points.size()) return a.normalized();
    const Vec2d b = points[beyond(points[second], second + 1)] - points[second];
    const double one = a.norm(), other = b.norm();
    const Vec2d slope = (1 + one / (one + other)) * a / one - one / (one + other) * b / other;
    return slope.norm() > 1e-9 ? slope.normalized() : a.normalized();
}

Vec2d reversed_tangent(Points points) {
    std::vector<Vec2d> backwards(points.begin(), points.end());
    std::ranges::reverse(backwards);
    return tangent_at_start(backwards);
}

void fit(Points points, const Vec2d& at_start, const Vec2d& at_end, double tolerance, std::vector<CubicPoints>& out) {
    constexpr int kIterations = 24;
    if (points.size() == 2) {
        const Vec2d third = (points[1] - points[0]) / 3;
        out.push_back({points[0], points[0] + third, points[1] - third, points[1]});
        return;
    }
    std::vector<double> s = chord_parameters(points);
    Worst worst;
    for (int i = 0; i < kIterations; ++i) {
        const CubicPoints cubic = fit_once(points, s, at_start, at_end);
        worst = worst_of(points, cubic, s);
        if (worst.distance <= tolerance) {
            out.push_back(cubic);
            return;
        }
        improve_parameters(points, cubic, s);
    }
    const std::size_t middle = std::clamp<std::size_t>(worst.index, 1, points.size() - 2);
    const Vec2d across = points[middle - 1] - points[middle + 1];
    const Vec2d tangent = across.norm() > 0 ? Vec2d(across.normalized()) : at_start;
    fit(points.first(middle + 1), at_start, tangent, tolerance, out);
    fit(points.subspan(middle), -tangent, at_end, tolerance, out);
}

}  // namespace

Vec2d point_on(const CubicPoints& c, double s) {
    const double r = 1 - s;
    return r * r * r * c[0] + 3 * r * r * s * c[1] + 3 * r * s * s * c[2] + s * s * s * c[3];
}

std::vector<CubicPoints> fit_curve(std::span<const Vec2d> points, const CurveFitOptions& options) {
    std::vector<Vec2d> different;
    for (const Vec2d& p : points) {
        if (different.empty() || p != different.back()) different.push_back(p);
    }
    std::vector<CubicPoints> cubics;
    if (different.size() < 2) return cubics;
    const Vec2d at_start = options.start_tangent.value_or(tangent_at_start(different));
    const Vec2d at_end = options.end_tangent.value_or(reversed_tangent(different));
    fit(different, at_start, at_end, options.tolerance, cubics);
    return cubics;
}

}  // namespace selvedge::sim
