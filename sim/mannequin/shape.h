#pragma once
// Deforms the base body by a set of shape parameters: each vertex moves to the weighted mean of the positions given by
// the deformations of torso, head, limbs, hands and feet.
#include <optional>
#include <vector>

#include "sim/mannequin/base.h"
#include "sim/mannequin/table.h"

namespace selvedge::sim {

// Deformation of the trunk: heights are remapped, and every horizontal slice is scaled about the trunk's axis by a
// profile over eleven levels.

// The parameters that calibration adjusts until the measured girths match the requested ones.
struct ShapeParameters {
    double height = 0;                 // m
    double stature = 1;                // height / height of the base body
    double inseam = 0;                 // new height of the base body's crotch level, m
    std::optional<double> waist = {};  // new height of the base body's waist, m; none: where its trunk has it
    double arm = 1;                    // arm length / that of the base body
    double shoulder = 1;               // shoulder width / that of the base body, subject to min_shoulder()
    double clearance = 0.9;            // minimum shoulder width relative to the scale of the upper chest
    double stance = 0;                 // of each leg, outward from the vertical, rad
    double bust_ratio = 1;             // bust / bust of the base body scaled to this height
    bool has_wide_wrist = false;       // wider than usual for its forearm: the lower arm tapers to it
    GirthValues scale;                 // radial scales at the levels of the girths
};

// The ratio of the wrist to the forearm, over that of the base body, up to which a profile of scales tapers the lower
// arm as a person's: the usual proportions (sim/mannequin/measures.cpp) give 1.08 and 1.10.
inline constexpr double kUsualWrist = 1.11;

// Scale of the head: the square root of the height ratio, because tall people do not have much larger heads.
double head_scale(const ShapeParameters& shape);

// Scale of upper arms and shoulder slope, which widen less than the chest.
double shoulder_slope_scale(const ShapeParameters& shape);

// The smallest scale of the shoulder width at which the arms clear the chest.
double min_shoulder(const ShapeParameters& shape, Sex sex);

class TorsoShape {
 public:
    // The base must outlive this object.
    TorsoShape(const MannequinBase& base, const ShapeParameters& shape);

    Vec3d bend(const Vec3d& x) const;

    // Maps a height of the base body to the deformed body, m.
    double height_of(double y) const { return heights_(y); }

 private:
    double lobe(double dy, double cosine) const;

    const MannequinBase& base_;
    double stature_;
    std::vector<double> levels_;
    Pchip heights_;
    EvenTable radial_;   // scale of a slice by height
    Pchip front_share_;  // additional share of the scaling that goes to the front
    Pchip widening_;     // of the shoulder girdle, in x only
    double lobes_ = 0;   // strength of the breasts relative to the rib cage
};

struct DeformedBody {
    std::vector<Vec3d> x;
    Landmarks landmarks;
};

DeformedBody bend_body(const MannequinBase& base, const ShapeParameters& shape);

// Length of upper and lower arm along their bones, m.
double arm_length(const Joints& joints);

}  // namespace selvedge::sim
