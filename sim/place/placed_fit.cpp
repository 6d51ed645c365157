#include "sim/place/placed_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "sim/mesh/sew.h"
#include "sim/place/body_girths.h"
#include "sim/place/garment_section.h"

namespace selvedge::sim {
namespace {

constexpr double kStep = 0.02;  // m, between levels

DrawMesh closed_mesh(GarmentMesh mesh) {
    merge_seams(mesh);
    return draw_mesh(mesh);
}

// Garment and body at one plane; a garment that does not go round all of the part there has no girth.
struct PlacedLevel {
    double at = 0;                     // m, along the part
    double y = 0;                      // m
    double body_girth = 0;             // m; 0: no such part
    std::optional<GarmentLoop> cloth;  // the longest
    Eigen::AlignedBox3d box;           // of the body's section
};

PlacedLevel level_of(const DrawMesh& closed, const std::optional<BodyGirth>& part, double at,
                     const std::vector<double>& strain_limits) {
    PlacedLevel level{.at = at, .y = 0, .body_girth = 0, .cloth = {}, .box = {}};
    if (!part) return level;
    level.y = part->plane.point.y();
    level.body_girth = part->length();
    for (const Vec3d& point : part->inside.points) level.box.extend(point);
    for (GarmentLoop& loop : cut_garment(closed, part->plane, strain_limits)) {
        const auto holds = [&](const Vec3d& centre) { return goes_round(loop.points, part->plane, centre); };
        if (!std::ranges::all_of(part->centres, holds)) continue;
        if (!level.cloth || loop.limit_girth > level.cloth->limit_girth) level.cloth = std::move(loop);
    }
    return level;
}

using PlacedLevels = std::vector<PlacedLevel>;  // along a part of the body

PlacedLevels trunk_levels(const DrawMesh& closed, const MeasuredBody& body, const std::vector<double>& strain_limits) {
    constexpr double kCrotch = 0.49, kArmpits = 0.74;  // shares of the stature, inside of which the trunk is alone
    const Proportions& proportions = body.proportions();
    PlacedLevels levels;
    for (double y = proportions.at(kCrotch); y < proportions.at(kArmpits); y += kStep)
        levels.push_back(level_of(closed, trunk_girth(body, y), y, strain_limits));
    return levels;
}

// Of an upper arm or a thigh.
PlacedLevels limb_levels(const DrawMesh& closed, const MeasuredBody& body, LimbKind kind,
                         const std::vector<double>& strain_limits) {
    constexpr double kFirst = 0.4;  // of its length: nearer to the trunk, planes across it meet that
    const Limb& limb = body.limbs()[kind];
    PlacedLevels levels;
    if (!limb.is_found || limb.joints.size() < 2) return levels;
    const double length = (limb.joints[1].centre - limb.joints[0].centre).norm();
    for (double at = kFirst * length; at < length; at += kStep)
        levels.push_back(level_of(closed, upper_limb_girth(body, kind, at / length), at, strain_limits));
    return levels;
}

// By how much the body's smallest girth is larger than the garment's largest, within reach of a level, relatively.
struct PlacedExcess {
    double value = 0;
    const PlacedLevel* narrowest = nullptr;
    const GarmentLoop* longest = nullptr;
};

PlacedExcess excess_at(const PlacedLevels& levels, const PlacedLevel& level, double reach) {
    PlacedExcess excess;
    for (const PlacedLevel& near : levels) {
        if (std::abs(near.at - level.at) > reach) continue;
        const bool is_narrower = !excess.narrowest || near.body_girth < excess.narrowest->body_girth;
        if (near.body_girth > 0 && is_narrower) excess.narrowest = &near;
        if (near.cloth && (!excess.longest || near.cloth->limit_girth > excess.longest->limit_girth))
            excess.longest = &*near.cloth;
    }
    excess.value = excess.narrowest->body_girth / excess.longest->limit_girth - 1;
    return excess;
}

TightLevel tight_level(const PlacedExcess& excess) {
    const PlacedLevel& at = *excess.narrowest;
    return {.y = at.y,
            .garment_girth = excess.longest->girth,
            .limit_girth = excess.longest->limit_girth,
            .body_girth = at.body_girth,
            .contact_girth = at.body_girth,
            .low = at.box.min(),
            .high = at.box.max()};
}

}  // namespace

std::optional<TightLevel> too_small_as_placed(const GarmentMesh& unsewn, const MeasuredBody& body,
                                              const PlacedFitOptions& options) {
    const DrawMesh closed = closed_mesh(unsewn);
    std::vector<PlacedLevels> parts{trunk_levels(closed, body, options.strain_limits)};
    for (const LimbKind kind : {LimbKind::LeftArm, LimbKind::RightArm, LimbKind::LeftLeg, LimbKind::RightLeg})
        parts.push_back(limb_levels(closed, body, kind, options.strain_limits));
    std::optional<TightLevel> worst;
    double most = options.excess;
    for (const PlacedLevels& levels : parts) {
        for (const PlacedLevel& level : levels) {
            if (!level.cloth || level.body_girth <= 0) continue;
            const PlacedExcess excess = excess_at(levels, level, options.slide);
            if (excess.value <= most) continue;
            most = excess.value;
            worst = tight_level(excess);
        }
    }
    return worst;
}

double depth_below_floor(const GarmentMesh& unsewn, const MeasuredBody& body) {
    double depth = 0;
    for (const Vec3d& x : unsewn.x) depth = std::max(depth, body.stature().floor - x.y());
    return depth;
}

}  // namespace selvedge::sim
