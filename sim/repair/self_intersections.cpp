#include "sim/repair/self_intersections.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace selvedge::sim {

namespace {

using Corners = std::array<Vec3d, 3>;

Corners corners(const Body& body, const std::array<int, 3>& triangle) {
    return {body.x[static_cast<std::size_t>(triangle[0])], body.x[static_cast<std::size_t>(triangle[1])],
            body.x[static_cast<std::size_t>(triangle[2])]};
}

struct Box {
    Vec3d low;
    Vec3d high;

    bool overlaps(const Box& other) const {
        return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
    }
};

std::vector<Box> triangle_boxes(const Body& body) {
    std::vector<Box> boxes;
    boxes.reserve(body.triangles.size());
    for (const auto& triangle : body.triangles) {
        const auto [a, b, c] = corners(body, triangle);
        boxes.push_back({a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)});
    }
    return boxes;
}

// Six times the signed volume of a tetrahedron: positive when p lies in front of the triangle a, b, c.
double orientation(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& p) {
    return (b - a).cross(c - a).dot(p - a);
}

// Whether the line through the two points passes through the triangle. Pre: it crosses the triangle's plane.
bool passes_inside(const Vec3d& from, const Vec3d& to, const Corners& t) {
    const double u = orientation(from, to, t[0], t[1]);
    const double v = orientation(from, to, t[1], t[2]);
    const double w = orientation(from, to, t[2], t[0]);
    return (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
}

int shared_vertices(const std::array<int, 3>& first, const std::array<int, 3>& second) {
    int shared = 0;
    for (const int v : first) shared += std::find(second.begin(), second.end(), v) != second.end() ? 1 : 0;
    return shared;
}

// Signed side of the plane of `t` on which x lies; exactly 0 for a corner of `t`, regardless of rounding.
double side_of(const Corners& t, const Vec3d& normal, const Vec3d& x) {
    return std::find(t.begin(), t.end(), x) != t.end() ? 0.0 : normal.dot(x - t[0]);
}

// Whether an edge of `first` pierces `second`. An edge that ends in a shared vertex never does.
bool an_edge_pierces(const Corners& first, const Corners& second) {
    const Vec3d normal = (second[1] - second[0]).cross(second[2] - second[0]);
    std::array<double, 3> side{};
    for (std::size_t k = 0; k < 3; ++k) side[k] = side_of(second, normal, first[k]);
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        if (side[k] * side[next] < 0 && passes_inside(first[k], first[next], second)) return true;
    }
    return false;
}

// A triangle in a grid cell; sorting makes the entries of one cell contiguous.
struct Entry {
    std::uint64_t cell = 0;
    int triangle = 0;
    auto operator<=>(const Entry&) const = default;
};

// 1.5 times the mean triangle size: few triangles span many cells, few cells hold many triangles.
double cell_size(const std::vector<Box>& boxes) {
    double sum = 0;
    for (const Box& box : boxes) sum += (box.high - box.low).maxCoeff();
    return std::max(1.5 * sum / static_cast<double>(boxes.size()), std::numeric_limits<double>::min());
}

std::vector<Entry> grid_entries(const std::vector<Box>& boxes) {
    constexpr double kMaxCells = 1 << 20;  // along an axis, so that three indices fit into 64 bits
    Vec3d low = boxes.front().low;
    Vec3d high = boxes.front().high;
    for (const Box& box : boxes) {
        low = low.cwiseMin(box.low);
        high = high.cwiseMax(box.high);
    }
    const double size = std::max(cell_size(boxes), (high - low).maxCoeff() / kMaxCells);
    const auto cell_of = [&](const Vec3d& x) -> Eigen::Array<std::uint64_t, 3, 1> {
        return ((x - low) / size).array().floor().cast<std::uint64_t>();
    };
    std::vector<Entry> entries;
    entries.reserve(4 * boxes.size());
    for (std::size_t t = 0; t < boxes.size(); ++t) {
        const auto first = cell_of(boxes[t].low);
        const auto last = cell_of(boxes[t].high);
        for (std::uint64_t i = first[0]; i <= last[0]; ++i) {
            for (std::uint64_t j = first[1]; j <= last[1]; ++j) {
                for (std::uint64_t k = first[2]; k <= last[2]; ++k) {
                    entries.push_back({(i << 42) | (j << 21) | k, static_cast<int>(t)});
                }
            }
        }
    }
    std::sort(entries.begin(), entries.end());
    return entries;
}

bool intersect(const Body& body, int first, int second) {
    const auto& a = body.triangles[static_cast<std::size_t>(first)];
    const auto& b = body.triangles[static_cast<std::size_t>(second)];
    if (shared_vertices(a, b) > 1) return false;
    const Corners x = corners(body, a);
    const Corners y = corners(body, b);
    return an_edge_pierces(x, y) || an_edge_pierces(y, x);
}

}  // namespace

std::vector<std::array<int, 2>> self_intersections(const Body& body) {
    std::vector<std::array<int, 2>> pairs;
    if (body.triangles.empty()) return pairs;
    const std::vector<Box> boxes = triangle_boxes(body);
    const std::vector<Entry> entries = grid_entries(boxes);
    for (auto first = entries.begin(); first != entries.end(); ++first) {
        for (auto second = first + 1; second != entries.end() && second->cell == first->cell; ++second) {
            const auto a = static_cast<std::size_t>(first->triangle);
            const auto b = static_cast<std::size_t>(second->triangle);
            if (boxes[a].overlaps(boxes[b]) && intersect(body, first->triangle, second->triangle)) {
                pairs.push_back({first->triangle, second->triangle});
            }
        }
    }
    std::sort(pairs.begin(), pairs.end());  // a pair may be found in several cells
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

}  // namespace selvedge::sim
