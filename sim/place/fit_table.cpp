#include "sim/place/fit_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "sim/body/landmarks.h"
#include "sim/body/section.h"
#include "sim/core/math.h"
#include "sim/place/garment_section.h"
#include "sim/place/limbs.h"

namespace selvedge::sim {
namespace {

constexpr double kSleevePosition = 0.5;  // of the way from shoulder to elbow: where sim/mannequin measures the arm
constexpr double kThighPosition = 0.25;  // of the way from hip to knee: below the crotch of any stance
constexpr double kLargestShare = 0.05;   // of the largest section's area, from which on a section is a part of the body
constexpr int kLevels = 12;              // at which a girth is measured to find the largest or the least

// Heights between which a girth lies, m.
struct Range {
    double low = 0;
    double high = 0;
};

// The sections that a girth goes round, and those beside them that it must leave out.
struct MeasuredPart {
    Plane plane;
    SectionLoop inside;                // all points of these sections
    std::vector<Vec3d> centres;        // of them
    std::vector<Vec3d> other_centres;  // of the sections that are not in it
};

bool is_trunk(const SectionLoop& loop, double stature, double largest) {
    return std::abs(loop.centre.x()) < 0.1 * stature && loop.area > 0.35 * largest;
}

void add_section(MeasuredPart& part, const SectionLoop& loop) {
    part.inside.points.insert(part.inside.points.end(), loop.points.begin(), loop.points.end());
    part.centres.push_back(loop.centre);
}

std::optional<MeasuredPart> trunk_at(const Body& body, double y, double stature) {
    MeasuredPart part{.plane = {.point = Vec3d(0, y, 0)}, .inside = {}, .centres = {}, .other_centres = {}};
    const std::vector<SectionLoop> loops = section(body, part.plane);
    double largest = 0;
    for (const SectionLoop& loop : loops) {
        if (std::abs(loop.centre.x()) < 0.1 * stature) largest = std::max(largest, loop.area);
    }
    for (const SectionLoop& loop : loops) {
        if (is_trunk(loop, stature, largest)) {
            add_section(part, loop);
        } else if (loop.area > kLargestShare * largest) {
            part.other_centres.push_back(loop.centre);
        }
    }
    if (part.centres.empty()) return std::nullopt;
    return part;
}

// Where the trunk has its largest girth in this range.
std::optional<MeasuredPart> widest_of_trunk(const Body& body, const Range& range, double stature) {
    std::optional<MeasuredPart> found;
    double best = 0;
    for (int i = 0; i <= kLevels; ++i) {
        std::optional<MeasuredPart> part = trunk_at(body, range.low + (range.high - range.low) * i / kLevels, stature);
        if (!part) continue;
        const double girth = tape_length(part->inside, part->plane);
        if (girth <= best) continue;
        best = girth;
        found = std::move(part);
    }
    return found;
}

// Shares of the stature between which bust and hip lie on bodies of all builds; the bust below the armpits, where
// the arms are apart from the trunk.
Range bust_range(const Stature& stature, const std::optional<double>& armpit) {
    const Range range{stature.floor + 0.69 * stature.height(), stature.floor + 0.76 * stature.height()};
    constexpr double kLandmarkError = 0.015;  // share of the stature: find_landmarks() is exact to a hundredth
    const double below_arms = armpit ? *armpit - kLandmarkError * stature.height() : range.high;
    return {range.low, std::max(range.low, std::min(range.high, below_arms))};
}

// Shares of the stature between which waist and hip lie on bodies whose crotch and armpits are where most people have
// them; those of other bodies lie in the same way between their own.
constexpr double kCrotchShare = 0.475, kArmpitShare = 0.757;
constexpr double kLowestHip = 0.47, kHighestHip = 0.56, kLowestWaist = 0.57, kHighestWaist = 0.685;
constexpr double kUsual = 0.02;  // of the stature: most people's, and what find_landmarks() does not tell

bool has_usual_trunk(const Stature& stature, const LandmarkHeights& landmarks) {
    const auto is_usual = [&](const std::optional<double>& y, double share) {
        return !y || std::abs((*y - stature.floor) / stature.height() - share) <= kUsual;
    };
    return is_usual(landmarks.crotch, kCrotchShare) && is_usual(landmarks.armpit, kArmpitShare);
}

// Of a share of the stature on a body of usual proportions.
double height_on_trunk(const Stature& stature, const LandmarkHeights& landmarks, double share) {
    const auto usual = [&](double other) { return stature.floor + other * stature.height(); };
    if (has_usual_trunk(stature, landmarks)) return usual(share);
    const double crotch = landmarks.crotch.value_or(usual(kCrotchShare));
    const double armpit = landmarks.armpit.value_or(usual(kArmpitShare));
    return std::lerp(crotch, armpit, (share - kCrotchShare) / (kArmpitShare - kCrotchShare));
}

Range hip_range(const Stature& stature, const LandmarkHeights& landmarks) {
    return {height_on_trunk(stature, landmarks, kLowestHip), height_on_trunk(stature, landmarks, kHighestHip)};
}

// Height of the smallest girth between hips and ribs; usual: that of a body of usual proportions.
double waist_height(const Body& body, const Stature& stature, const LandmarkHeights& landmarks, double usual) {
    if (has_usual_trunk(stature, landmarks)) return usual;
    constexpr double kStep = 0.005;  // of the usual stature
    double waist = usual, least = std::numeric_limits<double>::infinity();
    for (double share = kLowestWaist; share <= kHighestWaist; share += kStep) {
        const double y = height_on_trunk(stature, landmarks, share);
        const std::optional<MeasuredPart> part = trunk_at(body, y, stature.height());
        if (!part) continue;
        const double girth = tape_length(part->inside, part->plane);
        if (girth >= least) continue;
        least = girth;
        waist = y;
    }
    return waist;
}

// Square to the line from a limb's first joint to its second.
std::optional<MeasuredPart> limb_at(const Body& body, const Limb& limb, double position) {
    if (!limb.is_found || limb.joints.size() < 2) return std::nullopt;
    const Vec3d from = limb.joints[0].centre, to = limb.joints[1].centre;
    if (!((to - from).norm() > 0)) return std::nullopt;
    MeasuredPart part{.plane = {.point = from + position * (to - from), .normal = (to - from).normalized()},
                      .inside = {},
                      .centres = {},
                      .other_centres = {}};
    const std::vector<SectionLoop> loops = section(body, part.plane);
    const std::optional<SectionLoop> own = nearest_loop(loops, part.plane.point);
    if (!own) return std::nullopt;
    add_section(part, *own);
    for (const SectionLoop& loop : loops) {
        if (loop.centre != own->centre && loop.area > kLargestShare * own->area)
            part.other_centres.push_back(loop.centre);
    }
    return part;
}

// Where the neck is narrowest, square to the line from its base to the middle of the head.
std::optional<MeasuredPart> narrowest_of_neck(const Body& body, const Limb& head) {
    constexpr double kHighest = 0.6;  // of the way: below the chin
    std::optional<MeasuredPart> found;
    double best = 0;
    for (int i = 0; i <= kLevels; ++i) {
        std::optional<MeasuredPart> part = limb_at(body, head, kHighest * i / kLevels);
        if (!part) continue;
        const double girth = tape_length(part->inside, part->plane);
        if (found && girth >= best) continue;
        best = girth;
        found = std::move(part);
    }
    return found;
}

// The shortest loop of the garment that goes round all of the part and nothing else.
std::optional<double> girth_round(const DrawMesh& garment, const MeasuredPart& part) {
    std::optional<double> girth;
    for (const GarmentLoop& loop : cut_garment(garment, part.plane)) {
        const auto holds = [&](const Vec3d& centre) { return goes_round(loop, part.plane, centre); };
        if (!std::ranges::all_of(part.centres, holds) || std::ranges::any_of(part.other_centres, holds)) continue;
        if (!girth || loop.girth < *girth) girth = loop.girth;
    }
    return girth;
}

bool is_covered(const DrawMesh& garment, const MeasuredPart& part) {
    const auto is_round_it = [&](const GarmentLoop& loop) {
        return goes_round(loop, part.plane, part.centres.front());
    };
    return std::ranges::any_of(cut_garment(garment, part.plane), is_round_it);
}

// Of the uppermost level below the range's upper end at which the garment goes round the trunk.
std::optional<double> uppermost_girth(const DrawMesh& garment, const Body& body, const Range& range, double stature) {
    for (int i = 1; i <= kLevels; ++i) {
        const std::optional<MeasuredPart> trunk =
            trunk_at(body, range.high - (range.high - range.low) * i / kLevels, stature);
        if (!trunk) continue;
        if (const std::optional<double> girth = girth_round(garment, *trunk)) return girth;
    }
    return std::nullopt;
}

FitRow row_of(std::string_view measure, const std::optional<MeasuredPart>& part, const DrawMesh& garment) {
    FitRow row{.measure = measure};
    if (!part) return row;
    row.body_girth = tape_length(part->inside, part->plane);
    row.garment_girth = girth_round(garment, *part);
    return row;
}

}  // namespace

std::vector<FitRow> measure_fit(const DrawMesh& garment, const MeasuredBody& measured) {
    const Body& body = measured.body();
    const Stature& stature = measured.stature();
    const double height = stature.height();
    const LandmarkHeights& landmarks = measured.landmarks();
    const double waist_at = waist_height(body, stature, landmarks, torso_heights(body, stature).waist);
    const BodyLimbs& limbs = measured.limbs();
    const std::optional<MeasuredPart> bust = widest_of_trunk(body, bust_range(stature, landmarks.armpit), height);
    const std::optional<MeasuredPart> waist = trunk_at(body, waist_at, height);
    const Range hips = hip_range(stature, landmarks);
    std::vector<FitRow> rows;
    const auto add = [&](std::string_view measure, const std::optional<MeasuredPart>& part) {
        rows.push_back(row_of(measure, part, garment));
    };
    add("bust", bust);
    if (bust && !rows.back().garment_girth)
        rows.back().garment_girth = uppermost_girth(garment, body, {waist_at, bust->plane.point.y()}, height);
    add("waist", waist);
    if (waist && !is_covered(garment, *waist))
        rows.back().garment_girth = uppermost_girth(garment, body, {std::min(hips.high, waist_at), waist_at}, height);
    add("hip", widest_of_trunk(body, hips, height));
    add("neck", narrowest_of_neck(body, limbs[LimbKind::Head]));
    add("left_sleeve", limb_at(body, limbs[LimbKind::LeftArm], kSleevePosition));
    add("right_sleeve", limb_at(body, limbs[LimbKind::RightArm], kSleevePosition));
    add("left_thigh", limb_at(body, limbs[LimbKind::LeftLeg], kThighPosition));
    add("right_thigh", limb_at(body, limbs[LimbKind::RightLeg], kThighPosition));
    return rows;
}

}  // namespace selvedge::sim
