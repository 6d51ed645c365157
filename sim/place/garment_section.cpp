#include "sim/place/garment_section.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

namespace selvedge::sim {
namespace {

// An edge of the garment by its two vertices, lower index first.
struct CutEdge {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    auto operator<=>(const CutEdge&) const = default;
};

// The cut through one triangle, from its entry edge to its exit edge.
struct CutSegment {
    CutEdge entry;
    CutEdge exit;
    Vec3d point = Vec3d::Zero();       // on the entry edge
    Vec3d exit_point = Vec3d::Zero();  // on the exit edge
    double material_length = 0;        // m
    std::uint16_t panel = 0;
};

// Heights over the plane, m. A vertex in the plane counts as below it, so no loop passes through a vertex.
std::vector<double> heights_over(const Plane& plane, const DrawMesh& garment) {
    std::vector<double> heights;
    heights.reserve(garment.x.size());
    for (const Vec3f& x : garment.x) heights.push_back(plane.normal.dot(x.cast<double>() - plane.point));
    return heights;
}

std::optional<CutSegment> cut_triangle(const DrawMesh& garment, std::size_t triangle,
                                       const std::vector<double>& heights) {
    const auto& vertices = garment.triangles[triangle];
    const auto& corners = garment.u[triangle];
    CutSegment segment;
    Vec2d entry_u = Vec2d::Zero();
    Vec2d exit_u = Vec2d::Zero();
    bool is_cut = false;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const double from = heights[vertices[k]], to = heights[vertices[next]];
        const bool is_entry = from > 0;
        if (is_entry == (to > 0)) continue;
        is_cut = true;
        const Vec3d a = garment.x[vertices[k]].cast<double>();
        const Vec3d b = garment.x[vertices[next]].cast<double>();
        const double t = from / (from - to);
        const Vec2d u = (1 - t) * corners[k].cast<double>() + t * corners[next].cast<double>();
        const auto [low, high] = std::minmax(vertices[k], vertices[next]);
        (is_entry ? segment.entry : segment.exit) = {low, high};
        (is_entry ? entry_u : exit_u) = u;
        (is_entry ? segment.point : segment.exit_point) = a + t * (b - a);
    }
    if (!is_cut) return std::nullopt;
    segment.material_length = (exit_u - entry_u).norm();
    segment.panel = panel_of(garment, triangle);
    return segment;
}

// Sorted by entry edge.
std::vector<CutSegment> cut_triangles(const DrawMesh& garment, const Plane& plane) {
    const std::vector<double> heights = heights_over(plane, garment);
    std::vector<CutSegment> segments;
    for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
        if (const auto segment = cut_triangle(garment, t, heights)) segments.push_back(*segment);
    }
    std::stable_sort(segments.begin(), segments.end(),
                     [](const CutSegment& a, const CutSegment& b) { return a.entry < b.entry; });
    return segments;
}

// The segments at one level, and the way from one to the next. Neighbours have opposite directions where a seam joins
// right side to wrong side; there the walk goes on backwards, from exit to entry.
class CutWalk {
 public:
    struct Step {
        std::size_t segment = 0;  // the number of segments at the garment's boundary
        bool is_backward = false;
    };

    explicit CutWalk(const std::vector<CutSegment>& by_entry) : segments_(by_entry), by_exit_(by_entry.size()) {
        std::iota(by_exit_.begin(), by_exit_.end(), std::size_t{0});
        std::stable_sort(by_exit_.begin(), by_exit_.end(),
                         [&](std::size_t a, std::size_t b) { return segments_[a].exit < segments_[b].exit; });
    }

    Step next(const Step& at) const {
        const CutEdge edge = at.is_backward ? segments_[at.segment].entry : segments_[at.segment].exit;
        Step found = starting_at(edge, at.segment, at.is_backward);
        if (found.segment == segments_.size()) found = starting_at(edge, at.segment, !at.is_backward);
        return found;
    }

 private:
    // Another segment that starts at the edge when walked in that direction.
    Step starting_at(CutEdge edge, std::size_t from, bool is_backward) const {
        const auto edge_of = [&](std::size_t i) {
            return is_backward ? segments_[by_exit_[i]].exit : segments_[i].entry;
        };
        std::size_t low = 0, high = segments_.size();
        while (low < high) {
            const std::size_t middle = (low + high) / 2;
            if (edge_of(middle) < edge) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        for (; low < segments_.size() && edge_of(low) == edge; ++low) {
            const std::size_t segment = is_backward ? by_exit_[low] : low;
            if (segment != from) return {segment, is_backward};
        }
        return {segments_.size(), is_backward};
    }

    const std::vector<CutSegment>& segments_;
    std::vector<std::size_t> by_exit_;  // segments, sorted by exit edge
};

}  // namespace

std::vector<GarmentLoop> cut_garment(const DrawMesh& garment, const Plane& plane,
                                     const std::vector<double>& strain_limits) {
    const std::vector<CutSegment> segments = cut_triangles(garment, plane);
    const CutWalk walk(segments);
    std::vector<GarmentLoop> loops;
    std::vector<bool> used(segments.size(), false);
    for (std::size_t first = 0; first < segments.size(); ++first) {
        GarmentLoop loop;
        CutWalk::Step at{first};
        while (at.segment < segments.size() && !used[at.segment]) {
            const CutSegment& segment = segments[at.segment];
            used[at.segment] = true;
            loop.points.push_back(at.is_backward ? segment.exit_point : segment.point);
            loop.girth += segment.material_length;
            const double limit = strain_limits.empty() ? 0 : strain_limits[segment.panel];
            loop.limit_girth += (1 + limit) * segment.material_length;
            at = walk.next(at);
        }
        if (at.segment == first && !loop.points.empty()) loops.push_back(std::move(loop));
    }
    return loops;
}

bool goes_round(const std::vector<Vec3d>& loop, const Plane& plane, const Vec3d& point) {
    const Vec3d first = plane.normal.unitOrthogonal();
    const Vec3d second = plane.normal.cross(first);
    const auto seen = [&](const Vec3d& x) { return Vec2d(first.dot(x - point), second.dot(x - point)); };
    int winding = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2d a = seen(loop[i]);
        const Vec2d b = seen(loop[(i + 1) % loop.size()]);
        if ((a.y() <= 0) == (b.y() <= 0)) continue;
        const double side = cross2(a, b);
        if (a.y() <= 0 && side > 0) ++winding;
        if (a.y() > 0 && side < 0) --winding;
    }
    return winding != 0;
}

}  // namespace selvedge::sim
