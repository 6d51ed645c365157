#pragma once
// The base body of each sex, which is deformed into every mannequin: the cage with the points of the table, subdivided.
// Also the planes of the 15 girths and their measurement (docs/mannequin.md).
#include <array>
#include <cstddef>

#include "sim/body/section.h"
#include "sim/mannequin/cage.h"
#include "sim/mannequin/table.h"

namespace selvedge::sim {

// Measurement of the girths.

enum class Girth {
    Bust,
    Underbust,
    Waist,
    HighHip,
    Hip,
    Neck,
    Biceps,
    Elbow,
    Forearm,
    Wrist,
    Thigh,
    MidThigh,
    Knee,
    Calf,
    Ankle,
};
inline constexpr std::size_t kGirthCount = 15;

// One value per girth.
struct GirthValues {
    std::array<double, kGirthCount> value{};

    double& operator[](Girth girth) { return value[static_cast<std::size_t>(girth)]; }
    double operator[](Girth girth) const { return value[static_cast<std::size_t>(girth)]; }
};

// Joints and heights that define the girth planes.
struct Landmarks {
    Joints joints;
    TrunkLevels levels;
};

// The plane of a girth. Its point is near the centre of the measured part and selects the loop of the section.
Plane girth_plane(Girth girth, const Landmarks& landmarks);

// Girths (of the left limbs), m. Pre: every plane cuts the body.
GirthValues measure_girths(const Body& body, const Landmarks& landmarks);

// Girths across the left arm by position, from kForearmPosition to kWristPosition, m.
EvenTable lower_arm_girths(const Body& body, const Joints& joints);

// Position of the thigh's girth as a fraction of the way from hip joint to knee.
double thigh_position(const Landmarks& landmarks);

// Positions of the girths along an arm or leg: 0 at its root joint, 1 at elbow or knee, 2 at wrist or ankle.
inline constexpr double kMidThighPosition = 0.62;
inline constexpr double kCalfPosition = 1.28;
inline constexpr double kAnklePosition = 1.86;
inline constexpr double kBicepsPosition = 0.50;
inline constexpr double kForearmPosition = 1.22;
inline constexpr double kWristPosition = 1.95;
inline constexpr double kNeckPosition = 0.42;  // from neck joint to head joint

struct MannequinBase {
    Sex sex = Sex::Female;
    Body surface;        // without bones and skin
    VertexRows weights;  // one row per vertex, one column per joint
    Landmarks landmarks;
    double armpit = 0;    // height, m
    double height = 0;    // m
    EvenTable axis;       // z of the trunk's centre in the midplane as a function of height, m
    GirthValues girths;   // m
    EvenTable lower_arm;  // see lower_arm_girths()
};

// Pre: subdivisions >= 1, because the trunk's axis needs a vertex every 2 cm.
MannequinBase make_mannequin_base(Sex sex, int subdivisions);

}  // namespace selvedge::sim
