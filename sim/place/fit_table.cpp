#include "sim/place/fit_table.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "sim/body/landmarks.h"
#include "sim/core/math.h"
#include "sim/place/body_girths.h"
#include "sim/place/garment_section.h"
#include "sim/place/limbs.h"

namespace selvedge::sim {
namespace {

constexpr int kClosingLevels = 12;  // at which a garment is cut to find where it closes

// Heights between which a garment closes, m.
struct ClosingRange {
    double low = 0;
    double high = 0;
};

// The shortest loop of the garment that goes round all of the part and nothing else.
std::optional<double> girth_round(const DrawMesh& garment, const BodyGirth& part) {
    std::optional<double> girth;
    for (const GarmentLoop& loop : cut_garment(garment, part.plane)) {
        const auto holds = [&](const Vec3d& centre) { return goes_round(loop.points, part.plane, centre); };
        if (!std::ranges::all_of(part.centres, holds) || std::ranges::any_of(part.other_centres, holds)) continue;
        if (!girth || loop.girth < *girth) girth = loop.girth;
    }
    return girth;
}

bool is_covered(const DrawMesh& garment, const BodyGirth& part) {
    const auto is_round_it = [&](const GarmentLoop& loop) {
        return goes_round(loop.points, part.plane, part.centres.front());
    };
    return std::ranges::any_of(cut_garment(garment, part.plane), is_round_it);
}

// Of the uppermost level below the range's upper end at which the garment goes round the trunk.
std::optional<double> uppermost_girth(const DrawMesh& garment, const MeasuredBody& body, const ClosingRange& range) {
    for (int i = 1; i <= kClosingLevels; ++i) {
        const auto trunk = trunk_girth(body, range.high - (range.high - range.low) * i / kClosingLevels);
        if (!trunk) continue;
        if (const std::optional<double> girth = girth_round(garment, *trunk)) return girth;
    }
    return std::nullopt;
}

// The upper edge of trousers or of a skirt is no chest, however high above the waist it lies: a chest's cloth reaches
// the middle between waist and bust, and closes there or above.
std::optional<double> chest_under_armholes(const DrawMesh& garment, const MeasuredBody& body, const BodyGirth& bust,
                                           const BodyGirth& waist) {
    const double high = bust.plane.point.y(), low = (high + waist.plane.point.y()) / 2;
    if (high <= low) return std::nullopt;
    return uppermost_girth(garment, body, {low, high});
}

std::optional<double> waist_of_what_hangs_lower(const DrawMesh& garment, const MeasuredBody& body,
                                                const BodyGirth& waist) {
    const double high = waist.plane.point.y();
    return uppermost_girth(garment, body, {std::min(highest_hip(body), high), high});
}

FitRow row_of(std::string_view measure, const std::optional<BodyGirth>& part, const DrawMesh& garment) {
    FitRow row{.measure = measure};
    if (!part) return row;
    row.body_girth = part->length();
    row.plane = part->plane;
    row.garment_girth = girth_round(garment, *part);
    return row;
}

}  // namespace

std::vector<FitRow> measure_fit(const DrawMesh& garment, const MeasuredBody& body) {
    const std::optional<BodyGirth> bust = bust_girth(body), waist = waist_girth(body);
    std::vector<FitRow> rows;
    const auto add = [&](std::string_view measure, const std::optional<BodyGirth>& part) {
        rows.push_back(row_of(measure, part, garment));
    };
    add("bust", bust);
    if (bust && waist && !rows.back().garment_girth)
        rows.back().garment_girth = chest_under_armholes(garment, body, *bust, *waist);
    add("waist", waist);
    if (waist && !is_covered(garment, *waist))
        rows.back().garment_girth = waist_of_what_hangs_lower(garment, body, *waist);
    add("hip", hip_girth(body));
    add("neck", neck_girth(body));
    add("left_sleeve", sleeve_girth(body, LimbKind::LeftArm));
    add("right_sleeve", sleeve_girth(body, LimbKind::RightArm));
    add("left_thigh", thigh_girth(body, LimbKind::LeftLeg));
    add("right_thigh", thigh_girth(body, LimbKind::RightLeg));
    return rows;
}

}  // namespace selvedge::sim
