#include "sim/mannequin/measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <utility>

#include "sim/body/section.h"
#include "sim/core/error.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kLengthCount = 5;

using Measures = MannequinMeasures;
constexpr std::array<MeasureEntry, kLengthCount + kGirthCount> kEntries{{
    {"height", &Measures::height, 1.40, 2.10},
    {"inseam", &Measures::inseam, 0.55, 1.05},
    {"waist_height", &Measures::waist_height, 0.75, 1.45},
    {"shoulder", &Measures::shoulder, 0.25, 0.55},
    {"arm", &Measures::arm, 0.40, 0.75},
    {"bust", &Measures::bust, 0.70, 1.50},
    {"underbust", &Measures::underbust, 0.60, 1.40},
    {"waist", &Measures::waist, 0.50, 1.50},
    {"high_hip", &Measures::high_hip, 0.60, 1.55},
    {"hip", &Measures::hip, 0.70, 1.60},
    {"neck", &Measures::neck, 0.25, 0.55},
    {"biceps", &Measures::biceps, 0.18, 0.55},
    {"elbow", &Measures::elbow, 0.17, 0.45},
    {"forearm", &Measures::forearm, 0.16, 0.45},
    {"wrist", &Measures::wrist, 0.12, 0.25},
    {"thigh", &Measures::thigh, 0.38, 0.95},
    {"mid_thigh", &Measures::mid_thigh, 0.32, 0.80},
    {"knee", &Measures::knee, 0.26, 0.60},
    {"calf", &Measures::calf, 0.24, 0.60},
    {"ankle", &Measures::ankle, 0.16, 0.36},
}};

// Derives a girth that is not given from the given ones: powers of their ratios to the base body's girths scaled by
// stature, and a correction factor because the base bodies are slim at neck, wrist and ankle. The values are estimates,
// not from a survey.
struct Proportion {
    Girth girth;
    double bust = 0;
    double waist = 0;
    double hip = 0;
    double female = 1;
    double male = 1;
};

constexpr std::array<Proportion, 12> kProportions{{
    {.girth = Girth::Underbust, .bust = 0.70, .waist = 0.30},
    {.girth = Girth::HighHip, .waist = 0.50, .hip = 0.50},
    {.girth = Girth::Neck, .bust = 0.40, .female = 1.10},
    {.girth = Girth::Biceps, .bust = 0.55, .waist = 0.15},
    {.girth = Girth::Elbow, .bust = 0.40, .female = 1.03},
    {.girth = Girth::Forearm, .bust = 0.45, .female = 1.04},
    {.girth = Girth::Wrist, .bust = 0.25, .female = 1.14, .male = 1.08},
    {.girth = Girth::Thigh, .hip = 0.90},
    {.girth = Girth::MidThigh, .hip = 0.75},
    {.girth = Girth::Knee, .hip = 0.50},
    {.girth = Girth::Calf, .hip = 0.50},
    {.girth = Girth::Ankle, .hip = 0.25, .female = 1.10},
}};

constexpr double kChildHeight = 0.40;  // m: who is smaller is a wrong number
constexpr const char* kAdultData =
    ": its data are of adults and end there; for a child, name a body file instead (docs/mannequin.md)";

std::string as_limit(double metres) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g cm", 100 * metres);
    return text;
}

struct TrunkRatios {
    double bust = 1;
    double waist = 1;
    double hip = 1;
};

// A waist wider than bust and hip imply also widens the girths above and below it.
double spread_of_waist(const TrunkRatios& ratios, Girth girth, Sex sex) {
    const double excess = std::max(0.0, std::log(ratios.waist / std::sqrt(ratios.bust * ratios.hip)));
    if (girth == Girth::HighHip) return std::exp(0.25 * excess);
    if (girth == Girth::Underbust) return std::exp((sex == Sex::Female ? 0.08 : 0.25) * excess);
    return 1;
}

double follow(const Proportion& proportion, const TrunkRatios& ratios, Sex sex) {
    Proportion p = proportion;
    if (p.girth == Girth::Underbust && sex == Sex::Female) {
        p.bust = 0.88;
        p.waist = 0.12;
    }
    return (sex == Sex::Female ? p.female : p.male) * std::pow(ratios.bust, p.bust) * std::pow(ratios.waist, p.waist) *
           std::pow(ratios.hip, p.hip) * spread_of_waist(ratios, p.girth, sex);
}

[[noreturn]] void refuse(const MeasureEntry& entry, double value, double least, double most, const std::string& why) {
    throw InputError("mannequin", std::string(entry.name),
                     as_limit(value) + " is not between " + as_limit(least) + " and " + as_limit(most) + why);
}

}  // namespace

std::span<const MeasureEntry> measure_entries() {
    return kEntries;
}

const MeasureEntry& measure_entry(Girth girth) {
    return kEntries[kLengthCount + static_cast<std::size_t>(girth)];
}

void check_options(const MannequinOptions& options) {
    for (const MeasureEntry& entry : kEntries) {
        const std::optional<double>& value = options.measures.*entry.value;
        if (!value) continue;
        if (*value >= entry.least && *value <= entry.most) continue;  // false for NaN
        const bool is_child = entry.value == &Measures::height && *value < entry.least && *value >= kChildHeight;
        refuse(entry, *value, entry.least, entry.most, is_child ? kAdultData : "");
    }
    if (options.stance && !(*options.stance >= 0 && *options.stance <= kMaxStance)) {  // true for NaN
        char text[64];
        std::snprintf(text, sizeof text, "%.4g degrees is not between 0 and %.4g degrees", degrees(*options.stance),
                      degrees(kMaxStance));
        throw InputError("mannequin", "stance", text);
    }
    if (options.subdivisions < 1 || options.subdivisions > 4) {
        throw InputError("mannequin", "resolution",
                         std::to_string(options.subdivisions) + " is not between 1 and 4 steps of subdivision");
    }
}

void check_heights(const MannequinBase& base, const MannequinMeasures& measures) {
    const double height = measures.height.value_or(base.height);
    for (const auto& [measure, shares] :
         {std::pair(&Measures::inseam, kInseamShares), std::pair(&Measures::waist_height, kWaistShares)}) {
        const std::optional<double>& value = measures.*measure;
        if (!value || shares.hold(*value / height)) continue;
        refuse(*std::ranges::find(kEntries, measure, &MeasureEntry::value), *value, shares.least * height,
               shares.most * height, " for a height of " + as_limit(height));
    }
    if (!measures.inseam || !measures.waist_height) return;
    const double over = *measures.waist_height - *measures.inseam;
    if (kWaistOverCrotch.hold(over / height)) return;
    refuse(*std::ranges::find(kEntries, &Measures::waist_height, &MeasureEntry::value), *measures.waist_height,
           *measures.inseam + kWaistOverCrotch.least * height, *measures.inseam + kWaistOverCrotch.most * height,
           " for an inseam of " + as_limit(*measures.inseam));
}

GirthValues target_girths(const MannequinBase& base, const MannequinMeasures& measures) {
    const double stature = measures.height.value_or(base.height) / base.height;
    GirthValues targets = base.girths;
    for (double& girth : targets.value) girth *= stature;
    const auto ratio = [&](Girth girth) {
        const std::optional<double>& requested = measures.*measure_entry(girth).value;
        return requested ? *requested / targets[girth] : 1.0;
    };
    const TrunkRatios ratios{ratio(Girth::Bust), ratio(Girth::Waist), ratio(Girth::Hip)};
    for (const Proportion& p : kProportions) targets[p.girth] *= follow(p, ratios, base.sex);
    for (std::size_t g = 0; g < kGirthCount; ++g) {
        const std::optional<double>& requested = measures.*measure_entry(static_cast<Girth>(g)).value;
        if (requested) targets.value[g] = *requested;
    }
    return targets;
}

void set_stance(Joints& joints, double stance) {
    const Vec3d hip = joints[Joint::LeftUpperLeg];
    Vec3d& knee = joints[Joint::LeftLowerLeg];
    Vec3d& ankle = joints[Joint::LeftFoot];
    const double drop = hip.y() - ankle.y();
    const double inward = (ankle.x() - hip.x()) - drop * std::tan(stance);  // displacement of the ankle
    knee.x() -= inward * (hip.y() - knee.y()) / drop;
    ankle.x() -= inward;
    joints[Joint::LeftToe].x() -= inward;
}

LegGap measure_leg_gap(const Body& body, double crotch, const Joints& joints) {
    constexpr double kBelowCrotch = 0.04;  // m; above it the thighs merge
    const double top = crotch - kBelowCrotch;
    double nearest = std::numeric_limits<double>::max();
    double height = 0;
    const auto look_at = [&](const Vec3d& x) {
        if (x.y() > top + 1e-9 || std::abs(x.x()) >= nearest) return;
        nearest = std::abs(x.x());
        height = x.y();
    };
    for (const Vec3d& x : body.x) look_at(x);
    for (const SectionLoop& loop : section(body, {.point = Vec3d(0, top, 0)})) {
        for (const Vec3d& x : loop.points) look_at(x);
    }
    return {.width = 2 * nearest, .drop = joints[Joint::LeftUpperLeg].y() - height};
}

std::optional<double> better_stance(double stance, double wanted, const LegGap& gap) {
    constexpr double kAim = kMinLegGap + 0.0005;   // m
    constexpr double kAmple = kMinLegGap + 0.001;  // m
    constexpr double kLongestStep = radians(3);
    const bool is_narrow = gap.width < kMinLegGap && stance < kMaxStance;
    const bool is_needlessly_open = gap.width > kAmple && stance > wanted;
    if (!is_narrow && !is_needlessly_open) return std::nullopt;
    const double step = (kAim - gap.width) / (2 * gap.drop);  // both legs rotate
    return std::clamp(stance + std::clamp(step, -kLongestStep, kLongestStep), wanted, kMaxStance);
}

}  // namespace selvedge::sim
