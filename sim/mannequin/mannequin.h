#pragma once
// A mannequin from tape measurements: a subdivision cage with points from a table, deformed until its measured girths
// equal the requested ones. Measures, method and limits: docs/mannequin.md
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/body/body.h"

namespace selvedge::sim {

enum class Sex { Female, Male };

// In metres. Unset measures follow from the others by the base body's proportions; an unset height is the base body's.
struct MannequinMeasures {
    std::optional<double> height = {};
    std::optional<double> inseam = {};        // floor to crotch
    std::optional<double> waist_height = {};  // floor to waist
    std::optional<double> shoulder = {};      // joint to joint
    std::optional<double> arm = {};           // shoulder joint to wrist
    std::optional<double> bust = {};          // male: chest
    std::optional<double> underbust = {};
    std::optional<double> waist = {};
    std::optional<double> high_hip = {};
    std::optional<double> hip = {};
    std::optional<double> neck = {};
    std::optional<double> biceps = {};
    std::optional<double> elbow = {};
    std::optional<double> forearm = {};
    std::optional<double> wrist = {};
    std::optional<double> thigh = {};
    std::optional<double> mid_thigh = {};
    std::optional<double> knee = {};
    std::optional<double> calf = {};
    std::optional<double> ankle = {};
};

struct MannequinOptions {
    Sex sex = Sex::Female;
    MannequinMeasures measures = {};
    int subdivisions = 2;  // 1..4: 17 184, 68 736, 274 944 or 1 099 776 triangles

    // Angle of each leg outward from the vertical, hip joint to ankle, rad: 0 to 10 degrees; unset: 0.9 degrees.
    // Thick thighs open the legs further, until they are 8 mm apart.
    std::optional<double> stance = {};
};

// One measure: the requested value and the value measured on the finished surface, m.
struct MeasureReading {
    std::string_view name;
    std::optional<double> requested;
    double measured = 0;
    std::optional<double> level;  // of a girth: height of its plane's point
};

// The stance of the legs: the requested angle and the result.
struct StanceReading {
    std::optional<double> requested;  // rad
    double made = 0;                  // angle of the result, rad
    bool is_opened = false;           // more than requested or default, because the thighs would touch
    double gap = 0;                   // smallest distance between the legs from 4 cm below the crotch downward, m
};

// What was measured on the finished surface.
struct MannequinReadings {
    std::vector<MeasureReading> readings;  // all measures: lengths, then girths of trunk, neck, arm and leg
    StanceReading stance;
};

struct MeasureReport : MannequinReadings {
    std::vector<std::string> messages;  // requests that could not be met, with the reason; empty when all requested
                                        // measures are within 0.3 %, the legs stand as requested and apart,
                                        // and the surface has no self-intersections
    int iterations = 0;                 // iterations of measuring and correcting
};

struct Mannequin {
    Body body;  // closed and manifold, in an A-pose, with skeleton and skin weights
    MeasureReport report;
};

// Throws InputError when a measure is not a number or outside its accepted range. Equal options give identical bits.
Mannequin make_mannequin(const MannequinOptions& options = {});

// Body::made_from of the mannequin of these options, without making it: equal for equal options only.
std::string made_from(const MannequinOptions& options);

// Parses "mannequin:sex=female,bust=92,waist=74" (cm; all parts are optional; also "hips" for hip, "resolution" for
// subdivisions and "stance" in degrees). Throws InputError for an unknown name or invalid value.
MannequinOptions parse_mannequin(std::string_view text);

// "height", "inseam", ... in the order of the report.
std::vector<std::string_view> measure_names();

// The measure called `name` (also "hips"); nullptr when unknown.
std::optional<double>* find_measure(MannequinMeasures& measures, std::string_view name);

}  // namespace selvedge::sim
