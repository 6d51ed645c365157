#pragma once
// The named measures one by one, their allowed ranges, and the girths that follow from those that were given.
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

// All measures: height, inseam, shoulder, arm, then the girths in the order of Girth.
std::span<const MeasureEntry> measure_entries();
const MeasureEntry& measure_entry(Girth girth);

// Throws InputError that names the measure, its value and its range in cm.
void check_options(const MannequinOptions& options);

// Legs must leave room for a trunk, and the other way round: throws InputError when they do not.
void check_inseam(const MannequinBase& base, const MannequinMeasures& measures);

// Every girth that the body is to have, m: as given, or in proportion to bust, waist and hip.
GirthValues target_girths(const MannequinBase& base, const MannequinMeasures& measures);

// How far apart the mannequin's legs stand: the angle of each outward from the vertical, and the room between them.

constexpr double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

constexpr double degrees(double radians) {
    return radians * 180 / std::numbers::pi;
}

// Nearly parallel, as shop mannequins and those who are measured for a specification stand: a straight skirt that is
// drafted for the girths must close around both calves.
inline constexpr double kUsualStance = radians(0.9);
inline constexpr double kMostStance = radians(10);  // that can be asked for or that thick thighs may open the legs to

// Turns the left leg about the hip joint until it stands at the angle from hip joint to ankle. Knee and ankle keep
// their heights and the foot its direction, so that it stays flat on the floor.
void set_stance(Joints& joints, double stance);

// Where the legs come nearest to each other from 4 cm below the crotch downward.
struct LegGap {
    double width = 0;  // m
    double drop = 0;   // how far below the hip joint, m
};
LegGap measure_leg_gap(const Body& body, double crotch, const Joints& joints);

inline constexpr double kLeastLegGap = 0.008;  // m

// The stance for the next round of calibration: opened as far as the gap needs, closed again to `wanted` as far as it
// allows. Nothing when the present stance will do.
std::optional<double> better_stance(double stance, double wanted, const LegGap& gap);

}  // namespace selvedge::sim
