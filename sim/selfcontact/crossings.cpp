#include "sim/selfcontact/crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace selvedge::sim {
namespace {

Vec3f point_at(const float* points, std::uint32_t v) {
    return Eigen::Map<const Vec3f>(points + 4 * static_cast<std::size_t>(v));
}

// Six times the signed volume of a tetrahedron, m^3.
double volume(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
    return (a - d).dot((b - d).cross(c - d));
}

std::vector<ContactBox> boxes_of(const ContactSurface& surface, const float* points) {
    std::vector<ContactBox> boxes(surface.triangles.size());
    const auto at = [&](std::uint32_t v) { return Eigen::Map<const Vec4f>(points + 4 * static_cast<std::size_t>(v)); };
    for (std::size_t t = 0; t < boxes.size(); ++t) {
        const auto [a, b, c] = surface.triangles[t].vertices;
        boxes[t] = {at(a).cwiseMin(at(b)).cwiseMin(at(c)), at(a).cwiseMax(at(b)).cwiseMax(at(c))};
    }
    return boxes;
}

bool cross(const ContactSurface& surface, const float* points, std::uint32_t a, std::uint32_t b) {
    const auto pierces = [&](std::uint32_t from, std::uint32_t into) {
        return std::ranges::any_of(surface.triangles[from].edges, [&](std::uint32_t e) {
            return !surface.has_any(surface.triangles[into], surface.edges[e].ends) &&
                   find_crossing(surface, points, e, into);
        });
    };
    return pierces(a, b) || pierces(b, a);
}

}  // namespace

std::array<std::uint32_t, 5> vertices_of(const Crossing& crossing, const ContactSurface& surface) {
    const auto [p, q] = surface.edges[crossing.edge].ends;
    const auto [a, b, c] = surface.triangles[crossing.triangle].vertices;
    return {p, q, a, b, c};
}

std::optional<Crossing> find_crossing(const ContactSurface& surface, const float* points, std::uint32_t edge,
                                      std::uint32_t triangle) {
    const auto at = [&](std::uint32_t v) -> Vec3d { return point_at(points, v).cast<double>(); };
    const std::array<std::uint32_t, 2>& ends = surface.edges[edge].ends;
    const std::array<std::uint32_t, 3>& corners = surface.triangles[triangle].vertices;
    const Vec3d p = at(ends[0]), q = at(ends[1]), a = at(corners[0]), b = at(corners[1]), c = at(corners[2]);
    const double below = volume(a, b, c, p), above = volume(a, b, c, q);
    if ((below > 0) == (above > 0)) return std::nullopt;
    constexpr double kInPlane = 1e-7;  // m, the rounding of floats: an edge that is no farther from the plane is in it
    const double twice_area = (b - a).cross(c - a).norm();
    if (std::max(std::abs(below), std::abs(above)) <= kInPlane * twice_area) return std::nullopt;
    const double ab = volume(p, q, a, b), bc = volume(p, q, b, c), ca = volume(p, q, c, a);
    const bool is_inside = (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
    const double sum = ab + bc + ca;
    if (!is_inside || sum == 0) return std::nullopt;
    return Crossing{
        .edge = edge,
        .triangle = triangle,
        .along = static_cast<float>(below / (below - above)),
        .corners = {static_cast<float>(bc / sum), static_cast<float>(ca / sum), static_cast<float>(ab / sum)}};
}

std::vector<Crossing> find_crossings(const ContactSurface& surface, const PairSearch& search,
                                     std::span<const TrianglePair> pairs, const float* points) {
    std::vector<Crossing> crossings;
    const auto look = [&](std::uint32_t from, std::uint32_t into) {
        for (const std::uint32_t e : search.owned_edges(from)) {
            if (e == kNoElement) return;
            if (surface.has_any(surface.triangles[into], surface.edges[e].ends)) continue;
            if (const auto found = find_crossing(surface, points, e, into)) crossings.push_back(*found);
        }
    };
    for (const auto [a, b] : pairs) {
        look(a, b);
        look(b, a);
    }
    return crossings;
}

std::vector<TrianglePair> find_crossing_triangles(const ContactSurface& surface, const float* points) {
    const std::size_t count = surface.triangles.size();
    const std::vector<ContactBox> boxes = boxes_of(surface, points);
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t t) { return boxes[t].low.x(); });
    std::vector<TrianglePair> pairs;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t a = order[i];
        for (std::size_t j = i + 1; j < count && boxes[order[j]].low.x() <= boxes[a].high.x(); ++j) {
            const std::uint32_t b = order[j];
            if (!overlap(boxes[a], boxes[b])) continue;
            if (surface.has_any(surface.triangles[b], surface.triangles[a].vertices)) continue;
            if (cross(surface, points, a, b)) pairs.push_back({a, b});
        }
    }
    return pairs;
}

double contour_length(const ContactSurface& surface, const float* points, std::span<const TrianglePair> pairs) {
    double length = 0;
    for (const auto [a, b] : pairs) {
        std::vector<Vec3f> ends;
        const auto add = [&](std::uint32_t from, std::uint32_t into) {
            for (const std::uint32_t e : surface.triangles[from].edges) {
                const auto found = find_crossing(surface, points, e, into);
                const auto [p, q] = surface.edges[e].ends;
                if (found)
                    ends.push_back(point_at(points, p) * (1 - found->along) + point_at(points, q) * found->along);
            }
        };
        add(a, b);
        add(b, a);
        double longest = 0;
        for (const Vec3f& p : ends) {
            for (const Vec3f& q : ends) longest = std::max(longest, static_cast<double>((p - q).norm()));
        }
        length += longest;
    }
    return length;
}

}  // namespace selvedge::sim
