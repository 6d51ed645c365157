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

void set_body_girths(TightLevel& level, const std::vector<SectionLoop>& enclosed, const Plane& plane,
                     const FitOptions& options) {
    const double tape = girth_of(enclosed, plane);
    level.body_girth = tape + girth_of_gap(options.thickness);
    level.contact_girth = tape + girth_of_gap(options.contact_offset);
}

// Sets where the loop lies round the body, and the girths of the body there.
void put_round(TightLevel& level, const std::vector<SectionLoop>& enclosed, double y, const FitOptions& options) {
    set_body_girths(level, enclosed, level_at(y), options);
    level.y = level.low.y() = level.high.y() = y;
    level.enclosed = box_of(enclosed);
}

TightLevel level_of(const GarmentLoop& loop) {
    Eigen::AlignedBox3d box;
    for (const Vec3d& point : loop.points) box.extend(point);
    return {.garment_girth = loop.girth, .limit_girth = loop.limit_girth, .low = box.min(), .high = box.max()};
}

bool is_tight(const TightLevel& level, const FitOptions& options) {
    return level.garment_girth < (1 - options.tolerance) * level.contact_girth;
}

// Loops of the garment that go round the plane's point, on the line of a limb.
void add_tight_round(const DrawMesh& garment, const Body& body, const FitOptions& options, const Plane& plane,
                     std::vector<TightLevel>& levels) {
    const std::vector<GarmentLoop> loops = cut_garment(garment, plane, options.strain_limits);
    if (std::ranges::none_of(loops,
                             [&](const GarmentLoop& loop) { return goes_round(loop.points, plane, plane.point); }))
        return;
    const std::vector<SectionLoop> sections = section(body, plane);
    for (const GarmentLoop& loop : loops) {
        if (!goes_round(loop.points, plane, plane.point)) continue;
        const std::vector<SectionLoop> enclosed = enclosed_by(loop, sections, plane);
        if (enclosed.empty()) continue;
        TightLevel level = level_of(loop);
        level.y = plane.point.y();
        set_body_girths(level, enclosed, plane, options);
        level.enclosed = box_of(enclosed);
        if (is_tight(level, options) && goes_round_all(loop, enclosed, plane)) levels.push_back(level);
    }
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
        TightLevel level = level_of(loop);
        put_round(level, enclosed, y, options);
        if (is_tight(level, options) && goes_round_all(loop, enclosed, plane)) levels.push_back(level);
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

std::vector<TightLevel> tight_round_level_limbs(const DrawMesh& garment, const Body& body, const BodyLimbs& limbs,
                                                const FitOptions& options) {
    constexpr double kLevel = 0.5;  // sine of the angle to the level: steeper limbs are cut well by level planes
    SELVEDGE_ASSERT(options.step > 0);
    std::vector<TightLevel> levels;
    for (const LimbKind kind : {LimbKind::LeftArm, LimbKind::RightArm, LimbKind::LeftLeg, LimbKind::RightLeg}) {
        const std::vector<LimbJoint>& joints = limbs[kind].joints;
        for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
            const Vec3d &from = joints[i].centre, along = joints[i + 1].centre - from;
            const double length = along.norm();
            if (!(length > 0) || std::abs(along.y()) > kLevel * length) continue;
            for (double at = 0; at < length; at += options.step)
                add_tight_round(garment, body, options, {.point = from + at / length * along, .normal = along / length},
                                levels);
        }
    }
    return levels;
}

std::optional<TightLevel> too_small_for_limb(const DrawMesh& garment, const Body& body, const BodyLimbs& limbs,
                                             const Vec3d& x, const FitOptions& options) {
    const auto position = nearest_on_limbs(limbs, x);
    if (!position || !position->limb || *position->limb == LimbKind::Head) return std::nullopt;
    const std::vector<LimbJoint>& joints = limbs[*position->limb].joints;
    const Vec3d& from = joints[position->joint].centre;
    const Vec3d along = joints[position->joint + 1].centre - from;
    if (!(along.norm() > 0)) return std::nullopt;
    const Plane plane{.point = from + position->share * along, .normal = along.normalized()};
    const auto limb = nearest_loop(section(body, plane), plane.point);
    if (!limb) return std::nullopt;
    const double reach =
        2 * std::sqrt(limb->area / std::numbers::pi);  // m, from its middle: what is farther is another's
    const GarmentLoop* longest = nullptr;              // cloth that a limb cuts has scraps beside it
    const std::vector<GarmentLoop> loops = cut_garment(garment, plane, options.strain_limits);
    for (const GarmentLoop& loop : loops) {
        if ((middle_of_box(loop.points) - limb->centre).norm() > reach) continue;
        if (longest == nullptr || loop.girth > longest->girth) longest = &loop;
    }
    if (longest == nullptr) return std::nullopt;
    TightLevel level = level_of(*longest);
    level.y = plane.point.y();
    set_body_girths(level, {*limb}, plane, options);
    level.enclosed = box_of({*limb});
    constexpr double kWhole = 0.5;  // of the limb's girth: less is no sleeve or leg, but a scrap of one
    const bool is_whole = level.garment_girth > kWhole * level.body_girth;
    const bool is_too_small = shortfall(level, options) > 0 && level.limit_girth < level.body_girth;
    return is_whole && is_too_small ? std::optional(level) : std::nullopt;
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
