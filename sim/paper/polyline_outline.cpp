#include "sim/paper/polyline_outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "sim/core/math.h"
#include "sim/paper/fit_curve.h"

namespace selvedge::sim {
namespace {

double turn_at(const Vec2d& before, const Vec2d& at, const Vec2d& after) {
    const Vec2d a = at - before, b = after - at;
    return std::abs(std::atan2(cross2(a, b), a.dot(b)));
}

bool is_straight(std::span<const Vec2d> points, double tolerance) {
    const Vec2d chord = points.back() - points.front();
    const double length = chord.norm();
    if (!(length > 0)) return false;
    return std::ranges::all_of(
        points, [&](const Vec2d& p) { return std::abs(cross2(chord, p - points.front())) <= tolerance * length; });
}

void add_edge(DrawnPath& path, OutlineEdge edge, const Vec2d& start) {
    edge.start = static_cast<int>(path.vertices.size());
    edge.end = edge.start + 1;
    path.vertices.push_back(start);
    path.edges.push_back(std::move(edge));
}

void add_run(DrawnPath& path, std::span<const Vec2d> points, double tolerance) {
    path.turns.push_back(static_cast<int>(path.vertices.size()));
    if (is_straight(points, tolerance)) return add_edge(path, {}, points.front());
    for (const CubicPoints& cubic : fit_curve(points, {.tolerance = tolerance})) {
        OutlineEdge edge;
        edge.kind = CurveKind::Cubic;
        edge.control = {cubic[1], cubic[2]};
        add_edge(path, std::move(edge), cubic[0]);
    }
}

// Adds the ends of straight edges that run smoothly into curves: segments that are much longer than those beside them.
// A curve through both would bulge on the long one. Pre: the corners are sorted; so they stay.
void add_ends_of_straight_edges(const std::vector<Vec2d>& points, bool is_closed, std::vector<int>& corners) {
    constexpr double kMuchLonger = 4;  // a flattened curve has no such neighbours
    constexpr double kLeast = 0.02;    // of the whole line
    const int count = static_cast<int>(points.size());
    const int segments = is_closed ? count : count - 1;
    const auto length = [&](int i) {
        const int at = (i + count) % count;
        return (points[as_size((at + 1) % count)] - points[as_size(at)]).norm();
    };
    double whole = 0;
    for (int i = 0; i < segments; ++i) whole += length(i);
    std::vector<int> ends;
    for (int i = 0; i < segments; ++i) {
        const int next = (i + 1) % count;
        const bool begins = std::ranges::binary_search(corners, i), stops = std::ranges::binary_search(corners, next);
        if ((begins && stops) || length(i) < kLeast * whole) continue;
        const double before = begins ? 0 : length(i - 1), after = stops ? 0 : length(i + 1);
        if (length(i) > kMuchLonger * std::max(before, after)) ends.insert(ends.end(), {i, next});
    }
    corners.insert(corners.end(), ends.begin(), ends.end());
    std::ranges::sort(corners);
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
}

}  // namespace

std::vector<int> find_corners(const std::vector<Vec2d>& points, bool is_closed) {
    constexpr double kLeast = 18 * std::numbers::pi / 180;  // rad
    constexpr double kMuch = 2.5;                           // times the turns beside it
    const int count = static_cast<int>(points.size());
    std::vector<double> turns(points.size(), 0);
    const auto at = [&](int i) { return as_size((i + count) % count); };
    for (int i = 0; i < count; ++i) {
        if (!is_closed && (i == 0 || i + 1 == count)) continue;
        turns[as_size(i)] = turn_at(points[at(i - 1)], points[as_size(i)], points[at(i + 1)]);
    }
    std::vector<int> corners;
    for (int i = 0; i < count; ++i) {
        if (!is_closed && (i == 0 || i + 1 == count)) {
            corners.push_back(i);
            continue;
        }
        constexpr double kSharp = std::numbers::pi / 4;  // rad: a corner whatever is beside it
        const double own = turns[as_size(i)], beside = std::max(turns[at(i - 1)], turns[at(i + 1)]);
        const double other = std::min(turns[at(i - 1)], turns[at(i + 1)]);
        const double smooth = beside < kSharp ? beside : other < kSharp ? other : 0;  // of the curve that it may be on
        if (own > kSharp || (own > kLeast && own > kMuch * smooth)) corners.push_back(i);
    }
    return corners;
}

DrawnPath outline_of_points(std::vector<Vec2d> points, bool is_closed, const PolylineOptions& options) {
    DrawnPath path;
    path.is_closed = is_closed;
    std::vector<Vec2d> different;
    std::vector<int> image;
    for (const Vec2d& p : points) {
        if (different.empty() || p != different.back()) different.push_back(p);
        image.push_back(static_cast<int>(different.size()) - 1);
    }
    if (is_closed && different.size() > 1 && different.front() == different.back()) different.pop_back();
    if (different.size() < 2) return path;
    const int count = static_cast<int>(different.size());
    std::vector<int> corners;
    for (const int corner : options.corners) {
        if (corner >= 0 && as_size(corner) < image.size()) corners.push_back(image[as_size(corner)] % count);
    }
    std::ranges::sort(corners);
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    if (corners.empty()) corners = find_corners(different, is_closed);
    if (different.size() > 3) add_ends_of_straight_edges(different, is_closed, corners);
    if (corners.empty()) corners = {0, count / 2};  // a smooth loop begins anywhere
    if (corners.size() == 1 && is_closed) corners.push_back((corners[0] + count / 2) % count);
    std::ranges::sort(corners);
    const std::size_t runs = is_closed ? corners.size() : corners.size() - 1;
    for (std::size_t r = 0; r < runs; ++r) {
        const int from = corners[r];
        int to = corners[(r + 1) % corners.size()];
        if (to <= from) to += count;
        std::vector<Vec2d> run;
        for (int i = from; i <= to; ++i) run.push_back(different[as_size(i % count)]);
        add_run(path, run, options.tolerance);
    }
    if (is_closed) {
        path.edges.back().end = 0;
    } else {
        path.vertices.push_back(different[as_size(corners.back())]);
    }
    return path;
}

}  // namespace selvedge::sim
