#include "sim/mesh/planar.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>

namespace selvedge::sim {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct Segment {
    Vec2d start;
    Vec2d end;
};

// 1 if c is to the left of the line ab, -1 if to the right, 0 if on it; exact.
int side_of(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
    const auto point = [](const Vec2d& p) { return Kernel::Point_2(p.x(), p.y()); };
    return static_cast<int>(CGAL::orientation(point(a), point(b), point(c)));
}

bool boxes_meet(const Segment& a, const Segment& b) {
    for (int axis = 0; axis < 2; ++axis) {
        const auto [a_low, a_high] = std::minmax(a.start[axis], a.end[axis]);
        const auto [b_low, b_high] = std::minmax(b.start[axis], b.end[axis]);
        if (a_high < b_low || b_high < a_low) return false;
    }
    return true;
}

// Whether p is strictly between the ends of s. Pre: p is on the line of s.
bool is_between(const Vec2d& p, const Segment& s) {
    const int axis = std::abs(s.end.x() - s.start.x()) >= std::abs(s.end.y() - s.start.y()) ? 0 : 1;
    const auto [low, high] = std::minmax(s.start[axis], s.end[axis]);
    return low < p[axis] && p[axis] < high;
}

bool is_crossing(const Segment& a, const Segment& b) {
    if (!boxes_meet(a, b)) return false;
    if (a.start == b.start && a.end == b.end) return true;
    const int b_start = side_of(a.start, a.end, b.start);
    const int b_end = side_of(a.start, a.end, b.end);
    const int a_start = side_of(b.start, b.end, a.start);
    const int a_end = side_of(b.start, b.end, a.end);
    if (b_start * b_end < 0 && a_start * a_end < 0) return true;
    return (b_start == 0 && is_between(b.start, a)) || (b_end == 0 && is_between(b.end, a)) ||
           (a_start == 0 && is_between(a.start, b)) || (a_end == 0 && is_between(a.end, b));
}

}  // namespace

double distance_to_segment(const Vec2d& point, const Vec2d& start, const Vec2d& end) {
    const Vec2d along = end - start;
    const double squared = along.squaredNorm();
    const double t = squared > 0 ? std::clamp((point - start).dot(along) / squared, 0.0, 1.0) : 0.0;
    return (point - start - t * along).norm();
}

double distance_to_outline(const Vec2d& point, std::span<const Vec2d> outline) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        nearest = std::min(nearest, distance_to_segment(point, outline[i], outline[(i + 1) % outline.size()]));
    }
    return nearest;
}

double smallest_angle(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
    const auto angle = [](const Vec2d& at, const Vec2d& p, const Vec2d& q) {
        return std::atan2(std::abs(cross2(p - at, q - at)), (p - at).dot(q - at));
    };
    const double ab = (b - a).squaredNorm();
    const double bc = (c - b).squaredNorm();
    const double ca = (a - c).squaredNorm();
    if (ab <= bc && ab <= ca) return angle(c, a, b);
    return bc <= ca ? angle(a, b, c) : angle(b, c, a);
}

void weld(std::vector<Vec2d>& points) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if ((points[i] - points[k]).squaredNorm() < kWeldDistance * kWeldDistance) {
                points[i] = points[k];
                break;
            }
        }
    }
}

std::optional<std::pair<int, int>> find_crossing(std::span<const Vec2d> outline) {
    const auto segment = [&](std::size_t i) { return Segment{outline[i], outline[(i + 1) % outline.size()]}; };
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Segment first = segment(i);
        if (first.start == first.end) return std::pair(static_cast<int>(i), static_cast<int>(i));
        for (std::size_t k = i + 1; k < outline.size(); ++k) {
            if (is_crossing(first, segment(k))) return std::pair(static_cast<int>(i), static_cast<int>(k));
        }
    }
    return std::nullopt;
}

}  // namespace selvedge::sim
