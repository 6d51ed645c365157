#pragma once
// The named measures with their accepted ranges, the girths derived from the given ones, and the stance of the legs.
#include <numbers>
#include <optional>
#include <span>
#include <string_view>

#include "sim/mannequin/base.h"
#include "sim/mannequin/cage.h"
#include "sim/mannequin/mannequin.h"

namespace selvedge::sim {

struct MeasureEntry {
    std::string_view name;
    std::optional<double> MannequinMeasures::*value;
    double least = 0;  // m
    double most = 0;   // m
};

// All measures: height, inseam, waist_height, shoulder, arm, then the girths in the order of Girth.
std::span<const MeasureEntry> measure_entries();
const MeasureEntry& measure_entry(Girth girth);

// Throws InputError with the name, value and range (in cm) of a measure that is out of range.
void check_options(const MannequinOptions& options);

// Which shares of the height a mannequin can have.
struct HeightShares {
    double least = 0;
    double most = 0;

    bool hold(double share) const { return share >= least && share <= most; }
};
inline constexpr HeightShares kInseamShares{0.40, 0.53};
inline constexpr HeightShares kWaistShares{0.55, 0.70};
inline constexpr HeightShares kWaistOverCrotch{0.10, 0.225};  // 0.14 and 0.17 on the base bodies

// Throws InputError when inseam, waist_height, or one over the other are not shares of the height that a mannequin can
// have.
void check_heights(const MannequinBase& base, const MannequinMeasures& measures);

// Target girths, m: as given, or derived from bust, waist and hip.
GirthValues target_girths(const MannequinBase& base, const MannequinMeasures& measures);

// Stance: each leg's angle outward from the vertical, and the gap between the legs.

constexpr double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

constexpr double degrees(double radians) {
    return radians * 180 / std::numbers::pi;
}

// Nearly parallel, as on shop mannequins and people who are being measured: a straight skirt drafted for the girths
// must close around both calves.
inline constexpr double kUsualStance = radians(0.9);
inline constexpr double kMaxStance = radians(10);  // maximum that a request or thick thighs may give

// Rotates the left leg about the hip joint until the line from hip joint to ankle has this angle (rad). Knee and ankle
// keep their heights and the foot its direction, so it stays flat on the floor.
void set_stance(Joints& joints, double stance);

// The narrowest gap between the legs, from 4 cm below the crotch downward.
struct LegGap {
    double width = 0;  // m
    double drop = 0;   // below the hip joint, m
};
LegGap measure_leg_gap(const Body& body, double crotch, const Joints& joints);

inline constexpr double kMinLegGap = 0.008;  // m

// The stance (rad) for the next iteration of calibration: opened as far as the gap requires, or closed towards `wanted`
// as far as the gap allows. nullopt when the current stance is good.
std::optional<double> better_stance(double stance, double wanted, const LegGap& gap);

}  // namespace selvedge::sim
