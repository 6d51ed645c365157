#include "sim/place/fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "sim/body/section.h"
#include "sim/collide/surface_bvh.h"
#include "sim/core/assert.h"
#include "sim/core/parallel.h"
#include "sim/place/garment_section.h"

namespace selvedge::sim {
namespace {

Plane level_at(double y) {
    return {.point = Vec3d(0, y, 0), .normal = Vec3d::UnitY()};
}

// The body sections that the garment's loop encloses.
std::vector<SectionLoop> enclosed_by(const GarmentLoop& garment, const std::vector<SectionLoop>& body,
                                     const Plane& plane) {
    std::vector<SectionLoop> enclosed;
    std::ranges::copy_if(body, std::back_inserter(enclosed),
                         [&](const SectionLoop& loop) { return goes_round(garment.points, plane, loop.centre); });
    return enclosed;
}

// Whether the garment's loop goes round these sections, and not through them. Cloth that passes through the body
// encloses a part of it, of which the whole says nothing: trousers whose legs cut the hips are not too small for the
// hips.
bool goes_round_all(const GarmentLoop& garment, const std::vector<SectionLoop>& enclosed, const Plane& plane) {
    constexpr double kCore = 0.8;   // of a section: coarse cloth cuts the bulges of a body that it lies on
    constexpr double kShare = 0.9;  // of its points: a body's section need not be convex
    for (const SectionLoop& loop : enclosed) {
        const auto is_round = [&](const Vec3d& point) {
            return goes_round(garment.points, plane, loop.centre + kCore * (point - loop.centre));
        };
        const auto held = std::ranges::count_if(loop.points, is_round);
        if (static_cast<double>(held) < kShare * static_cast<double>(loop.points.size())) return false;
    }
    return true;
}

Eigen::AlignedBox2d box_of(const std::vector<SectionLoop>& loops) {
    Eigen::AlignedBox2d box;
    for (const SectionLoop& loop : loops) {
        for (const Vec3d& point : loop.points) box.extend(Vec2d(point.x(), point.z()));
    }
    return box;
}

// Length of one tape around all of the sections, m; 0 when there are none.
double girth_of(const std::vector<SectionLoop>& loops, const Plane& plane) {
    SectionLoop together;
    for (const SectionLoop& loop : loops)
        together.points.insert(together.points.end(), loop.points.begin(), loop.points.end());
    return tape_length(together, plane);
}

// A curve at this distance (m) outside a convex one is longer by this, m (Steiner's formula).
double girth_of_gap(double distance) {
    return 2 * std::numbers::pi * distance;
}

// Sets where the loop lies round the body, and the girths of the body there.
void put_round(TightLevel& level, const std::vector<SectionLoop>& enclosed, double y, const FitOptions& options) {
    const double tape = girth_of(enclosed, level_at(y));
    level.y = level.low.y() = level.high.y() = y;
    level.body_girth = tape + girth_of_gap(options.thickness);
    level.contact_girth = tape + girth_of_gap(options.contact_offset);
    level.enclosed = box_of(enclosed);
}

void add_tight_loops(const DrawMesh& garment, const LevelSections& body, const FitOptions& options, double y,
                     std::vector<TightLevel>& levels) {
    const Plane plane = level_at(y);
    const std::vector<GarmentLoop> loops = cut_garment(garment, plane, options.strain_limits);
    if (loops.empty()) return;
    const std::vector<SectionLoop> sections = body.at(y);
    for (const GarmentLoop& loop : loops) {
        const std::vector<SectionLoop> enclosed = enclosed_by(loop, sections, plane);
        if (enclosed.empty()) continue;
        Eigen::AlignedBox3d box;
        for (const Vec3d& point : loop.points) box.extend(point);
        TightLevel level{
            .garment_girth = loop.girth, .limit_girth = loop.limit_girth, .low = box.min(), .high = box.max()};
        put_round(level, enclosed, y, options);
        const bool is_tight = level.garment_girth < (1 - options.tolerance) * level.contact_girth;
        if (is_tight && goes_round_all(loop, enclosed, plane)) levels.push_back(std::move(level));
    }
}

// The loop at the next level: round the sections that lie inside of what it encloses here; none if there are none.
std::optional<TightLevel> slid(const TightLevel& level, const LevelSections& body, double step,
                               const FitOptions& options) {
    std::vector<SectionLoop> followed = body.at(level.y + step);
    std::erase_if(followed, [&](const SectionLoop& loop) {
        return !level.enclosed.contains(Vec2d(loop.centre.x(), loop.centre.z()));
    });
    if (followed.empty()) return std::nullopt;
    TightLevel next = level;
    put_round(next, followed, level.y + step, options);
    const Vec2d moved = next.enclosed.center() - level.enclosed.center();
    for (Vec3d* corner : {&next.low, &next.high}) *corner += Vec3d(moved.x(), 0, moved.y());
    return next;
}

// The narrowest on its way up or down, until the body gets wider or ends.
TightLevel narrowest_towards(const TightLevel& level, const LevelSections& body, double step,
                             const FitOptions& options) {
    TightLevel narrowest = level;
    for (std::optional<TightLevel> at = slid(level, body, step, options); at; at = slid(*at, body, step, options)) {
        if (at->body_girth > (1 + options.tolerance) * narrowest.body_girth) break;
        if (at->body_girth < narrowest.body_girth) narrowest = *at;
    }
    return narrowest;
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
    const LevelSections sections(body);
    for (int i = first; i <= last; ++i) add_tight_loops(garment, sections, options, i * options.step, levels);
    return levels;
}

double shortfall(const TightLevel& level, const FitOptions& options) {
    const bool is_smaller = level.garment_girth < (1 - options.tolerance) * level.body_girth;
    return is_smaller ? level.body_girth - level.garment_girth : 0;
}

TightLevel slid_to_narrowest(const TightLevel& level, const LevelSections& body, const FitOptions& options) {
    const TightLevel higher = narrowest_towards(level, body, options.step, options);
    const TightLevel lower = narrowest_towards(level, body, -options.step, options);
    return lower.body_girth < higher.body_girth ? lower : higher;
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
