#include "sim/body/section.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace selvedge::sim {

namespace {

// An edge of the surface by its two vertices, the lower index first and in the upper half: one number to compare.
using CutEdge = std::uint64_t;

CutEdge cut_edge(int one, int other) {
    const auto [low, high] = std::minmax(one, other);
    return static_cast<CutEdge>(low) << 32U | static_cast<std::uint32_t>(high);
}

// The part of the section inside one triangle, from its entry edge to its exit edge. On a closed oriented surface every
// cut edge is the entry of exactly one triangle and the exit of exactly one, so segments are chained without comparing
// points.
struct CutSegment {
    CutEdge entry = 0;
    CutEdge exit = 0;
};

std::vector<double> distances(const Body& body, const Plane& plane) {
    std::vector<double> distance(body.x.size());
    for (std::size_t v = 0; v < body.x.size(); ++v) distance[v] = (body.x[v] - plane.point).dot(plane.normal);
    return distance;
}

// A vertex in the plane counts as below it, as if the plane were raised by an infinitesimal amount. So no edge lies in
// the plane and no loop passes through a vertex. (Edelsbrunner and Muecke 1990, Simulation of simplicity)
bool is_above(double distance) {
    return distance > 0;
}

// distance: of a vertex over the plane.
template <class Distance>
void cut_triangle(const std::array<int, 3>& triangle, const Distance& distance, std::vector<CutSegment>& segments) {
    const std::array<bool, 3> above{is_above(distance(triangle[0])), is_above(distance(triangle[1])),
                                    is_above(distance(triangle[2]))};
    if (above[0] == above[1] && above[1] == above[2]) return;
    CutSegment segment;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        if (above[k] == above[next]) continue;
        (above[k] ? segment.entry : segment.exit) = cut_edge(triangle[k], triangle[next]);
    }
    segments.push_back(segment);
}

template <class Distance>
Vec3d cut_point(const Body& body, const Distance& distance, CutEdge edge) {
    const int first = static_cast<int>(edge >> 32U), second = static_cast<int>(edge & 0xFFFFFFFFU);
    const Vec3d& low = body.x[static_cast<std::size_t>(first)];
    const Vec3d& high = body.x[static_cast<std::size_t>(second)];
    const double from = distance(first);
    return low + from / (from - distance(second)) * (high - low);
}

// Area and centroid as a fan of triangles from the first point; coordinates relative to that point avoid cancellation.
void measure_area(SectionLoop& loop, const Plane& plane) {
    const Vec3d& origin = loop.points.front();
    Vec3d moment = Vec3d::Zero();
    double area = 0;
    for (std::size_t i = 1; i + 1 < loop.points.size(); ++i) {
        const Vec3d a = loop.points[i] - origin;
        const Vec3d b = loop.points[i + 1] - origin;
        const double part = 0.5 * plane.normal.dot(a.cross(b));
        area += part;
        moment += part * (a + b) / 3;
    }
    loop.area = std::abs(area);
    loop.centre = area == 0 ? origin : Vec3d(origin + moment / area);
}

// Segments are sorted by entry edge. On a faulty surface several may have the same entry; each is used once.
std::size_t find_unused(const std::vector<CutSegment>& segments, const std::vector<bool>& used, CutEdge entry) {
    auto it = std::lower_bound(segments.begin(), segments.end(), entry,
                               [](const CutSegment& segment, CutEdge edge) { return segment.entry < edge; });
    for (; it != segments.end() && it->entry == entry; ++it) {
        const auto index = static_cast<std::size_t>(it - segments.begin());
        if (!used[index]) return index;
    }
    return segments.size();
}

// Andrew's monotone chain; the first point is repeated at the end.
std::vector<Vec2d> convex_hull(std::vector<Vec2d> points) {
    std::sort(points.begin(), points.end(),
              [](const Vec2d& a, const Vec2d& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
    std::vector<Vec2d> hull;
    const auto add = [&](const Vec2d& point, std::size_t fixed) {
        while (hull.size() >= fixed + 2 && cross2(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0) {
            hull.pop_back();
        }
        hull.push_back(point);
    };
    for (const Vec2d& point : points) add(point, 0);
    const std::size_t lower = hull.size() - 1;
    for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
    return hull;
}

template <class Distance>
std::vector<SectionLoop> chain(const Body& body, const Plane& plane, const Distance& distance,
                               std::vector<CutSegment> segments) {
    std::stable_sort(segments.begin(), segments.end(),
                     [](const CutSegment& a, const CutSegment& b) { return a.entry < b.entry; });
    std::vector<SectionLoop> loops;
    std::vector<bool> used(segments.size(), false);
    for (std::size_t first = 0; first < segments.size(); ++first) {
        if (used[first]) continue;
        SectionLoop loop;
        std::size_t at = first;
        while (at < segments.size()) {
            used[at] = true;
            loop.points.push_back(cut_point(body, distance, segments[at].entry));
            if (segments[at].exit == segments[first].entry) break;
            at = find_unused(segments, used, segments[at].exit);
        }
        if (at == segments.size()) continue;  // ends at a hole of an open surface: not a closed loop
        measure_area(loop, plane);
        if (loop.area > 0) loops.push_back(std::move(loop));  // a tip that only touches the plane has zero area
    }
    return loops;
}

}  // namespace

std::vector<SectionLoop> section(const Body& body, const Plane& plane) {
    const std::vector<double> distances_of = distances(body, plane);
    const auto distance = [&](int vertex) { return distances_of[static_cast<std::size_t>(vertex)]; };
    std::vector<CutSegment> segments;
    for (const auto& triangle : body.triangles) cut_triangle(triangle, distance, segments);
    return chain(body, plane, distance, std::move(segments));
}

LevelSections::LevelSections(const Body& body) : body_(body) {
    constexpr std::size_t kSlabs = 256;
    if (body.x.empty()) return;
    const HeightRange range = height_range(body);
    low_ = range.low;
    per_metre_ = range.high > range.low ? static_cast<double>(kSlabs) / (range.high - range.low) : 0;
    const auto slabs = [&](const std::array<int, 3>& triangle) {
        const auto height = [&](std::size_t k) { return body.x[static_cast<std::size_t>(triangle[k])].y(); };
        const auto [low, high] = std::minmax({height(0), height(1), height(2)});
        return std::array{slab_of(low), slab_of(high)};
    };
    first_.assign(kSlabs + 1, 0);
    for (const auto& triangle : body.triangles) {
        const auto [low, high] = slabs(triangle);
        for (std::size_t slab = low; slab <= high; ++slab) ++first_[slab + 1];
    }
    for (std::size_t slab = 0; slab < kSlabs; ++slab) first_[slab + 1] += first_[slab];
    triangles_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t t = 0; t < body.triangles.size(); ++t) {
        const auto [low, high] = slabs(body.triangles[t]);
        for (std::size_t slab = low; slab <= high; ++slab) triangles_[next[slab]++] = static_cast<std::uint32_t>(t);
    }
}

std::size_t LevelSections::slab_of(double y) const {
    const double slab = std::floor((y - low_) * per_metre_);
    return static_cast<std::size_t>(std::clamp(slab, 0.0, static_cast<double>(first_.size() - 2)));
}

std::vector<SectionLoop> LevelSections::at(double y) const {
    if (first_.empty()) return {};
    const Plane plane{.point = Vec3d(0, y, 0)};
    const auto distance = [&](int vertex) { return body_.x[static_cast<std::size_t>(vertex)].y() - y; };
    const std::size_t slab = slab_of(y);
    std::vector<CutSegment> segments;
    segments.reserve(first_[slab + 1] - first_[slab]);
    for (std::uint32_t i = first_[slab]; i < first_[slab + 1]; ++i)
        cut_triangle(body_.triangles[triangles_[i]], distance, segments);
    return chain(body_, plane, distance, std::move(segments));
}

double tape_length(const SectionLoop& loop, const Plane& plane) {
    if (loop.points.size() < 2) return 0;
    const Vec3d along = plane.normal.unitOrthogonal();
    const Vec3d across = plane.normal.cross(along);
    std::vector<Vec2d> flat;
    flat.reserve(loop.points.size());
    for (const Vec3d& point : loop.points) {
        flat.emplace_back((point - plane.point).dot(along), (point - plane.point).dot(across));
    }
    const std::vector<Vec2d> hull = convex_hull(std::move(flat));
    double length = 0;
    for (std::size_t i = 0; i + 1 < hull.size(); ++i) length += (hull[i + 1] - hull[i]).norm();
    return length;
}

std::optional<SectionLoop> nearest_loop(const std::vector<SectionLoop>& loops, const Vec3d& near) {
    const auto nearest = std::min_element(loops.begin(), loops.end(), [&](const SectionLoop& a, const SectionLoop& b) {
        return (a.centre - near).squaredNorm() < (b.centre - near).squaredNorm();
    });
    return nearest == loops.end() ? std::nullopt : std::optional<SectionLoop>(*nearest);
}

}  // namespace selvedge::sim
