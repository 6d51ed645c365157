#include "sim/place/fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include "sim/body/section.h"
#include "sim/collide/surface_bvh.h"
#include "sim/core/assert.h"
#include "sim/core/parallel.h"

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

// One closed loop of the garment at a level.
struct GarmentLoop {
    std::vector<Vec3d> points;
    double girth = 0;        // m, in material coordinates
    double limit_girth = 0;  // m, at the fabrics' strain limits
};

// A vertex in the plane counts as below it, so no loop passes through a vertex.
bool is_above(const Vec3f& x, double y) {
    return static_cast<double>(x.y()) > y;
}

std::optional<CutSegment> cut_triangle(const DrawMesh& garment, std::size_t triangle, double y) {
    const auto& vertices = garment.triangles[triangle];
    const auto& corners = garment.u[triangle];
    CutSegment segment;
    Vec2d entry_u = Vec2d::Zero();
    Vec2d exit_u = Vec2d::Zero();
    bool is_cut = false;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const Vec3d a = garment.x[vertices[k]].cast<double>();
        const Vec3d b = garment.x[vertices[next]].cast<double>();
        const bool is_entry = is_above(garment.x[vertices[k]], y);
        if (is_entry == is_above(garment.x[vertices[next]], y)) continue;
        is_cut = true;
        const double t = (y - a.y()) / (b.y() - a.y());
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
std::vector<CutSegment> cut(const DrawMesh& garment, double y) {
    std::vector<CutSegment> segments;
    for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
        if (const auto segment = cut_triangle(garment, t, y)) segments.push_back(*segment);
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

std::vector<GarmentLoop> closed_loops(const std::vector<CutSegment>& segments, const std::vector<double>& limits) {
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
            const double limit = limits.empty() ? 0 : limits[segment.panel];
            loop.limit_girth += (1 + limit) * segment.material_length;
            at = walk.next(at);
        }
        if (at.segment == first && !loop.points.empty()) loops.push_back(std::move(loop));
    }
    return loops;
}

// Whether the loop encloses the point when seen from above: its winding number is not 0. Folded cloth may intersect
// itself, but not as far in as the centre of a body section. (Sunday 2001)
bool goes_round(const GarmentLoop& loop, const Vec3d& point) {
    int winding = 0;
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
        const Vec3d a = loop.points[i] - point;
        const Vec3d b = loop.points[(i + 1) % loop.points.size()] - point;
        if ((a.z() <= 0) == (b.z() <= 0)) continue;
        const double side = cross2({a.x(), a.z()}, {b.x(), b.z()});
        if (a.z() <= 0 && side > 0) ++winding;
        if (a.z() > 0 && side < 0) --winding;
    }
    return winding != 0;
}

// Length of one tape around all body sections that the garment's loop encloses, m; 0 when there are none.
double enclosed_girth(const GarmentLoop& garment, const std::vector<SectionLoop>& body, const Plane& plane) {
    SectionLoop enclosed;
    for (const SectionLoop& loop : body) {
        if (!goes_round(garment, loop.centre)) continue;
        enclosed.points.insert(enclosed.points.end(), loop.points.begin(), loop.points.end());
    }
    return tape_length(enclosed, plane);
}

void add_tight_loops(const DrawMesh& garment, const Body& body, const FitOptions& options, double y,
                     std::vector<TightLevel>& levels) {
    const std::vector<GarmentLoop> loops = closed_loops(cut(garment, y), options.strain_limits);
    if (loops.empty()) return;
    const Plane plane{.point = Vec3d(0, y, 0), .normal = Vec3d::UnitY()};
    const std::vector<SectionLoop> sections = section(body, plane);
    for (const GarmentLoop& loop : loops) {
        const double tape = enclosed_girth(loop, sections, plane);
        if (tape == 0) continue;
        // A curve at distance d outside a convex one is longer by 2 pi d (Steiner's formula).
        const double contact_girth = tape + 2 * std::numbers::pi * options.contact_offset;
        if (loop.girth >= (1 - options.tolerance) * contact_girth) continue;
        Eigen::AlignedBox3d box;
        for (const Vec3d& point : loop.points) box.extend(point);
        levels.push_back({.y = y,
                          .garment_girth = loop.girth,
                          .limit_girth = loop.limit_girth,
                          .body_girth = tape + 2 * std::numbers::pi * options.thickness,
                          .contact_girth = contact_girth,
                          .low = box.min(),
                          .high = box.max()});
    }
}

}  // namespace

std::vector<TightLevel> tight_levels(const DrawMesh& garment, const Body& body, const FitOptions& options) {
    SELVEDGE_ASSERT(options.step > 0);
    SELVEDGE_ASSERT(garment.u.size() == garment.triangles.size());
    SELVEDGE_ASSERT(std::all_of(garment.x.begin(), garment.x.end(), [](const Vec3f& x) { return x.allFinite(); }));
    std::vector<TightLevel> levels;
    if (garment.x.empty()) return levels;
    const auto [low, high] = std::minmax_element(garment.x.begin(), garment.x.end(),
                                                 [](const Vec3f& a, const Vec3f& b) { return a.y() < b.y(); });
    const auto first = static_cast<int>(std::ceil(static_cast<double>(low->y()) / options.step));
    const auto last = static_cast<int>(std::floor(static_cast<double>(high->y()) / options.step));
    for (int i = first; i <= last; ++i) add_tight_loops(garment, body, options, i * options.step, levels);
    return levels;
}

double shortfall(const TightLevel& level, const FitOptions& options) {
    const bool is_smaller = level.garment_girth < (1 - options.tolerance) * level.body_girth;
    return is_smaller ? level.body_girth - level.garment_girth : 0;
}

double explained_strain(const std::vector<TightLevel>& levels, const Vec3d& x, const FitOptions& options) {
    double strain = 0;
    for (const TightLevel& level : levels) {
        const Vec3d outside = (level.low - x).cwiseMax(x - level.high);
        if (outside.maxCoeff() <= options.reach)
            strain = std::max(strain, level.contact_girth / level.garment_girth - 1);
    }
    return strain;
}

std::vector<float> measure_clearance(const std::vector<Vec3f>& points, const Body& body) {
    const SurfaceBvh surface(body);
    std::vector<float> distances(points.size(), std::numeric_limits<float>::infinity());
    constexpr std::size_t kGrain = 256;
    parallel_for(points.size(), kGrain, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const auto closest = surface.closest(points[i], std::numeric_limits<float>::infinity());
            if (closest) distances[i] = closest->distance;
        }
    });
    return distances;
}

}  // namespace selvedge::sim
