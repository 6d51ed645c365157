#pragma once
// The named measures one by one, their allowed ranges, and the girths that follow from those that were given.
#include <span>
#include <string_view>

#include "sim/body/mannequin.h"
#include "sim/body/mannequin_base.h"

namespace selvedge {

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

}  // namespace selvedge
