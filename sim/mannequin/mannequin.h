#pragma once
// A shop mannequin from tape measurements: a subdivision cage from ring counts and a table of figures, bent until the
// tape reads what was asked.  (definitions of the measures, method, limits: docs/mannequin.md)
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/body/body.h"

namespace selvedge::sim {

enum class Sex { Female, Male };

// All in metres. What is unset follows the others by the base body's proportions; height is then the base body's.
struct MannequinMeasures {
    std::optional<double> height = {};
    std::optional<double> inseam = {};    // floor to crotch
    std::optional<double> shoulder = {};  // width from joint to joint
    std::optional<double> arm = {};       // shoulder joint to wrist
    std::optional<double> bust = {};      // male: chest
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

    // Each leg's angle outward from the vertical, hip joint to ankle, 0 to 10 degrees, rad; unset: 0.9 degrees. Thick
    // thighs open it until they are 8 mm apart.
    std::optional<double> stance = {};
};

// One measure as asked for and as read off the finished surface, m.
struct MeasureReading {
    std::string_view name;
    std::optional<double> asked;
    double measured = 0;
    std::optional<double> level;  // of a girth: height of the middle of the tape
};

// How the legs stand.
struct StanceReading {
    std::optional<double> asked;  // rad
    double made = 0;              // rad
    bool is_opened = false;       // beyond what was asked or is usual, because the thighs would touch
    double gap = 0;               // least distance between the legs from 4 cm below the crotch downward, m
};

struct MeasureReport {
    std::vector<MeasureReading> readings;  // every measure: lengths, then girths of trunk, neck, arm and leg
    StanceReading stance;
    std::vector<std::string> messages;  // what could not be met and why: empty when all asked measures are
                                        // within 0.3 %, the legs stand as asked and apart, and
                                        // the surface does not cut itself
    int rounds = 0;                     // of measuring and correcting
};

struct Mannequin {
    Body body;  // closed and manifold, in an A-pose, with skeleton and skin weights
    MeasureReport report;
};

// Throws InputError when a measure is no number or outside the range that make_mannequin accepts for it.
// Equal options give equal bits.
Mannequin make_mannequin(const MannequinOptions& options = {});

// Reads "mannequin:sex=female,bust=92,waist=74" (cm, all parts optional, also "hips" for hip, "resolution" for
// subdivisions and "stance" in degrees). Throws InputError for what it does not know.
MannequinOptions parse_mannequin(std::string_view text);

// "height", "inseam", ... in the order of the report.
std::vector<std::string_view> measure_names();

// The measure called `name` (also "hips"), or nullptr.
std::optional<double>* find_measure(MannequinMeasures& measures, std::string_view name);

}  // namespace selvedge::sim
