#include "sim/place/fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "sim/body/section.h"
#include "sim/collide/surface_bvh.h"
#include "sim/core/assert.h"
#include "sim/core/parallel.h"
#include "sim/place/garment_section.h"

namespace selvedge::sim {
namespace {

// Length of one tape around all body sections that the garment's loop encloses, m; 0 when there are none.
double enclosed_girth(const GarmentLoop& garment, const std::vector<SectionLoop>& body, const Plane& plane) {
    SectionLoop enclosed;
    for (const SectionLoop& loop : body) {
        if (!goes_round(garment, plane, loop.centre)) continue;
        enclosed.points.insert(enclosed.points.end(), loop.points.begin(), loop.points.end());
    }
    return tape_length(enclosed, plane);
}

void add_tight_loops(const DrawMesh& garment, const Body& body, const FitOptions& options, double y,
                     std::vector<TightLevel>& levels) {
    const Plane plane{.point = Vec3d(0, y, 0), .normal = Vec3d::UnitY()};
    const std::vector<GarmentLoop> loops = cut_garment(garment, plane, options.strain_limits);
    if (loops.empty()) return;
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
