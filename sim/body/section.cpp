#include "sim/body/section.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace selvedge::sim {

namespace {

// An edge of the surface by its two vertices, lower index first.
struct CutEdge {
    int low = 0;
    int high = 0;
    auto operator<=>(const CutEdge&) const = default;
};

// The part of the section inside one triangle, from its entry edge to its exit edge. On a closed oriented surface every
// cut edge is the entry of exactly one triangle and the exit of exactly one, so segments are chained without comparing
// points.
struct CutSegment {
    CutEdge entry;
    CutEdge exit;
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

std::vector<CutSegment> cut_triangles(const Body& body, const std::vector<double>& distance) {
    std::vector<CutSegment> segments;
    for (const auto& triangle : body.triangles) {
        const std::array<bool, 3> above{is_above(distance[static_cast<std::size_t>(triangle[0])]),
                                        is_above(distance[static_cast<std::size_t>(triangle[1])]),
                                        is_above(distance[static_cast<std::size_t>(triangle[2])])};
        if (above[0] == above[1] && above[1] == above[2]) continue;
        CutSegment segment;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            if (above[k] == above[next]) continue;
            const auto [low, high] = std::minmax(triangle[k], triangle[next]);
            (above[k] ? segment.entry : segment.exit) = {low, high};
        }
        segments.push_back(segment);
    }
    return segments;
}

Vec3d cut_point(const Body& body, const std::vector<double>& distance, CutEdge edge) {
    const auto low = static_cast<std::size_t>(edge.low);
    const auto high = static_cast<std::size_t>(edge.high);
    const double t = distance[low] / (distance[low] - distance[high]);
    return body.x[low] + t * (body.x[high] - body.x[low]);
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

}  // namespace

std::vector<SectionLoop> section(const Body& body, const Plane& plane) {
    const std::vector<double> distance = distances(body, plane);
    std::vector<CutSegment> segments = cut_triangles(body, distance);
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
